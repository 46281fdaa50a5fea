// A constant real correction is a scaled parameter, a constant 1 + iη a loss factor, in every rail solution.

#include <gtest/gtest.h>

#include <array>

#include <functional>
#include <numbers>

#include "tests/unit/lanes/in_turn.hpp"
#include "tests/unit/track/wei2016_track.hpp"
#include "track/rail/exact_rail.hpp"
#include "track/rail/modal_rail.hpp"
#include "track/rail/rolling_receptance.hpp"
#include "track/statics/seat_stiffness.hpp"

namespace railpem::track {
namespace {

using Complex = std::complex<double>;
constexpr double kPad = 40e6;

lanes::FactorCurve constant(Complex value) {
    return {.frequency_hz = {30.0}, .value = {value}};
}

/// A track and what it differs by from its parameters.
struct Track : TrackParameters {
    TrackModifiers modifiers;
};

Track two_layer_track() {
    Track track{wei2016_track(), {}};
    track.rail.loss_factor = 0.01;
    track.rail_dampers = {{.mass_kg_per_m = 10.0, .frequency_hz = 150.0}};
    track.support = {.model = SupportModel::two_layer,
                     .mass_kg = 140.0,
                     .stiffness_n_per_m = 60e6,
                     .damping_n_s_per_m = 5e4,
                     .loss_factor = 0.05};
    track.support.bending_modes = {{}};
    return track;
}

Track timoshenko_track() {
    Track track = two_layer_track();
    track.rail.beam = Beam::timoshenko;
    return track;
}

/// Receptances between three points and their trackbed forces at four frequencies.
std::vector<Complex> exact(const Track& track) {
    const ExactRail rail = uniform_rail(track, {0.0, 2.4, 2.75}, kPad, track.modifiers);
    ExactRailWorkspace work(rail);
    const lanes::Real omega = lanes::tests::in_turn({8.0, 90.0, 600.0, 5000.0});
    const RailReceptance& found = rail_receptance(rail, omega, work);
    std::vector<Complex> values;
    for (const auto* list : {&found.between, &found.trackbed})
        for (const lanes::Complex& value : *list)
            for (int lane = 0; lane < lanes::width; ++lane) values.push_back(value[lane]);
    return values;
}

std::vector<Complex> modal(const Track& track) {
    const std::vector<double> pads{-1.8, -1.2, -0.6, 0.0, 0.6, 1.2, 1.8};
    const ModalRail rail = modal_rail(track, pads, {0.0, 0.7}, 30, track.modifiers);
    std::vector<Complex> values;
    for (const double f : {5.0, 60.0, 400.0}) {
        const Eigen::VectorXcd seats = Eigen::VectorXcd::Constant(static_cast<Eigen::Index>(pads.size()),
                                                                  seat_stiffness(track, kPad, 1.0, f, track.modifiers));
        const ModalReceptance found = modal_receptance(rail, f, seats);
        values.insert(values.end(), found.at_points.data(), found.at_points.data() + found.at_points.size());
        values.insert(values.end(), found.trackbed.data(), found.trackbed.data() + found.trackbed.size());
    }
    return values;
}

std::vector<Complex> rolling(const Track& track) {
    std::vector<Complex> values;
    for (const double f : {15.0, 120.0}) {
        const RollingReceptance found = rolling_receptance(track, kPad, {0.0, -2.4}, 22.0, f, 1, track.modifiers);
        values.insert(values.end(), found.values.begin(), found.values.end());
    }
    return values;
}

void expect_equal(const std::vector<Complex>& found, const std::vector<Complex>& expected,
                  const std::vector<Complex>& plain, double tolerance) {
    double change = 0.0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_NEAR(std::abs(found[i] / expected[i] - 1.0), 0.0, tolerance) << i;
        change = std::max(change, std::abs(plain[i] / expected[i] - 1.0));
    }
    EXPECT_GT(change, 0.01) << "the correction must be felt";
}

struct Correction {
    const char* name;
    std::function<void(Track&)> correct, reference;
};

void heavier(Track& track) {
    track.rail.mass_kg_per_m *= 1.2;
    track.rail_dampers.front().mass_kg_per_m *= 1.2;
    // Timoshenko: a larger area keeps the rotary inertia m·I/A, which bears no correction, and κA is kept as well.
    track.rail.cross_section_m2 *= 1.2;
    track.rail.shear_coefficient /= 1.2;
}

class TrackCorrection : public testing::TestWithParam<Correction> {};

TEST_P(TrackCorrection, EqualsTheScaledParameter) {
    using Solution = std::vector<Complex> (*)(const Track&);
    const std::pair<Solution, Track> solutions[]{{exact, two_layer_track()},
                                                 {exact, timoshenko_track()},
                                                 {modal, two_layer_track()},
                                                 {rolling, two_layer_track()}};
    for (const auto& [solve, plain] : solutions) {
        Track corrected = plain, scaled = plain;
        GetParam().correct(corrected);
        GetParam().reference(scaled);
        // Rounding times the conditions: 1e5 of the modal stiffness. The quadrature of rolling wheels is as fine as the
        // resonances that the stated laws have: a correction does not steer it, a loss factor does. Its own tolerance
        // is 1e-5 of the receptance at the force, of which the first order is 1e-3.
        expect_equal(solve(corrected), solve(scaled), solve(plain),
                     solve == exact     ? 1e-12
                     : solve == rolling ? 2e-3
                                        : 1e-10);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Places, TrackCorrection,
    testing::Values(Correction{"rail", [](Track& track) { track.modifiers.rail = constant(1.2); }, heavier},
                    Correction{"pads", [](Track& track) { track.modifiers.pads = constant(1.2); },
                               [](Track& track) {
                                   // The shape takes the scale of the spring: K0 is given to the solutions from
                                   // outside.
                                   track.pads.reference_frequency_hz /= std::pow(1.2, 1.0 / track.pads.exponent);
                                   track.pads.damping_n_s_per_m *= 1.2;
                               }},
                    Correction{"support", [](Track& track) { track.modifiers.support = constant(1.2); },
                               [](Track& track) {
                                   track.support.stiffness_n_per_m *= 1.2;
                                   track.support.damping_n_s_per_m *= 1.2;
                               }},
                    Correction{"pad_loss",
                               [](Track& track) {
                                   track.pads.damping_n_s_per_m = 0.0;
                                   track.modifiers.pads = constant({1.0, 0.3});
                               },
                               [](Track& track) {
                                   track.pads.damping_n_s_per_m = 0.0;
                                   track.pads.loss_law = LossLaw::constant;
                                   track.pads.loss_factor = 0.3;
                               }},
                    Correction{"support_loss",
                               [](Track& track) {
                                   track.support.damping_n_s_per_m = track.support.loss_factor = 0.0;
                                   track.modifiers.support = constant({1.0, 0.4});
                               },
                               [](Track& track) {
                                   track.support.damping_n_s_per_m = 0.0;
                                   track.support.loss_factor = 0.4;
                               }}),
    [](const auto& tested) { return std::string(tested.param.name); });

/// Each frequency has its own value, and the seats of the two rail solutions agree about it.
TEST(SeatCorrection, VariesWithFrequencyAlikeInBothSolutions) {
    Track track = two_layer_track();
    track.modifiers.pads = {.frequency_hz = {10.0, 200.0}, .value = {{1.2, 0.1}, {0.7, 0.4}}};
    track.modifiers.support = {.frequency_hz = {20.0, 100.0}, .value = {{0.9, 0.2}, {1.3, 0.1}}};
    const lanes::Real omega = lanes::tests::in_turn({30.0, 200.0, 500.0, 3000.0});
    const lanes::Complex lanewise = SupportLaw(track.pads, track.support, omega, track.modifiers).stiffness(kPad, 0.8);
    for (int lane = 0; lane < lanes::width; ++lane) {
        const Complex single =
            seat_stiffness(track, kPad, 0.8, omega[lane] / (2.0 * std::numbers::pi), track.modifiers);
        EXPECT_NEAR(std::abs(lanewise[lane] / single - 1.0), 0.0, 1e-13) << lane;
    }
}

TEST(SeatCorrection, RigidGroundHasNone) {
    Track track{wei2016_track(), {}};
    const Complex plain = seat_stiffness(track, kPad, 1.0, 50.0, track.modifiers);
    track.modifiers.support = constant(1.2);
    EXPECT_EQ(seat_stiffness(track, kPad, 1.0, 50.0, track.modifiers), plain);
}

}  // namespace
}  // namespace railpem::track
