// The train over a periodic track by Bloch waves that the deviating seats scatter, against the same one place at a
// time: an equilibrium of its own from the unloaded track, and the whole matrix of receptances by condensation of
// finite elements of rail.

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "every_track_effect.hpp"
#include "pem/coupling/passing_lines.hpp"
#include "pem/rail/case_equilibrium.hpp"
#include "pem/rail/passing_positions.hpp"
#include "track/rail/exact_rail.hpp"

namespace {

using namespace railpem;
using Complex = std::complex<double>;

lanes::Real spread(double frequency, double ratio) {
    lanes::Real omega{};
    for (int lane = 0; lane < lanes::width; ++lane)
        omega[lane] = 2.0 * std::numbers::pi * frequency * std::pow(ratio, lane);
    return omega;
}

/// Σ_j C_ij with the failed seats counted from `first_seat`, from nothing but the case.
std::vector<lanes::Complex> one_place(pem::CaseParameters c, double bay_share, int first_seat, lanes::Real omega) {
    const std::vector<double> wheels = vehicle::wheel_positions(c.vehicle);
    c.track.wheel_offset_m = bay_share * c.track.spacing_m;
    for (track::FailedFasteners& failed : c.track.failed_fasteners) failed.first_seat = first_seat;
    const track::ExactRail rail = track::exact_rail(c.track, wheels, pem::dynamic_equilibrium(c));
    track::ExactRailWorkspace workspace(rail);
    const track::RailReceptance& receptance = track::rail_receptance(rail, omega, workspace);
    std::vector<lanes::Complex> sum(wheels.size());
    for (std::size_t i = 0; i < wheels.size(); ++i)
        for (std::size_t j = 0; j < wheels.size(); ++j)
            sum[i] += receptance.at(static_cast<int>(i), static_cast<int>(j));
    return sum;
}

double difference(const pem::CaseParameters& c, const std::vector<double>& shares, const std::vector<int>& first_seats,
                  lanes::Real omega) {
    const std::vector<double> wheels = vehicle::wheel_positions(c.vehicle);
    const pem::PassingPositions positions(c, wheels, shares, first_seats);
    const std::vector<lanes::Complex> found = positions.deflection(omega);
    double largest = 0.0;
    for (std::size_t b = 0; b < shares.size(); ++b)
        for (std::size_t s = 0; s < first_seats.size(); ++s) {
            const std::vector<lanes::Complex> direct = one_place(c, shares[b], first_seats[s], omega);
            for (std::size_t i = 0; i < wheels.size(); ++i)
                for (int lane = 0; lane < lanes::width; ++lane) {
                    const Complex value = found[positions.place(b, s) * wheels.size() + i][lane],
                                  expected = direct[i][lane];
                    largest = std::max(largest, std::abs(value - expected) / std::abs(expected));
                }
        }
    return largest;
}

const std::vector<double> kShares{0.0, 1.0 / 12.0, 0.5, 0.9};
const std::vector<int> kSeats{0, -1, -2, -5, -7};

/// The direct rail leaves seats out that differ by less than 1e-10, and both equilibria end within 1e-10 of the load:
/// 1e-9.
constexpr double kBoth = 1e-9;

TEST(PassingPositions, EveryTrackEffectAgreesWithOnePlaceAtATime) {
    const pem::CaseParameters c = tests::every_track_effect();
    for (const double f : {0.5, 4.6, 30.0, 100.0, 140.0, 400.0})
        EXPECT_LT(difference(c, kShares, kSeats, spread(f, 1.07)), kBoth) << f;
}

TEST(PassingPositions, TheSimplestTrackAgreesToo) {
    pem::CaseParameters c = tests::paper_case(1);
    for (const double f : {0.5, 37.0, 160.0, 900.0, 1100.0, 3000.0})
        EXPECT_LT(difference(c, kShares, {0}, spread(f, 1.07)), kBoth) << f;
    c.track.failed_fasteners = {{.every = 3, .remaining_stiffness_fraction = 0.3}};
    for (const double f : {0.5, 37.0, 160.0, 900.0, 1100.0, 3000.0})
        EXPECT_LT(difference(c, kShares, {0, -1, -2}, spread(f, 1.07)), kBoth) << f;
}

/// Distances of the wheels that are no whole numbers of bays, and pads that the rail leaves and that leave their
/// measured range.
TEST(PassingPositions, HardCasesOfTheEquilibriumAgree) {
    pem::CaseParameters c = tests::paper_case(3);
    c.vehicle.wheelbase_m = 2.5;
    c.vehicle.bogie_distance_m = 17.3;
    c.track.statics.clip_preload_n = 200.0;
    c.track.failed_fasteners = {{.every = 2, .remaining_stiffness_fraction = 0.0}};
    EXPECT_LT(difference(c, kShares, {0, -1}, spread(20.0, 1.3)), kBoth);
    c.track.support = {
        .model = track::SupportModel::two_layer, .mass_kg = 150.0, .stiffness_n_per_m = 20e6, .loss_factor = 0.5};
    c.track.statics.wheel_load_n = 140e3;
    EXPECT_LT(difference(c, kShares, {0, -1}, spread(20.0, 1.3)), kBoth);
}

/// Without damping the outgoing wave is told from the incoming one by a limit, and waves draw near each other at the
/// cut-on frequency of the rail on its pads, 161 Hz. 1e-8: both ways lose digits there.
TEST(PassingPositions, NoDampingAndTheEdgeOfThePassBand) {
    pem::CaseParameters c = tests::paper_case(1);
    c.track.pads.damping_n_s_per_m = 0.0;
    c.track.failed_fasteners = {{.every = 4}};
    const double cut_on = std::sqrt(1.4 * 26.7e6 / 0.6 / 60.64) / (2.0 * std::numbers::pi);
    for (const double f : {30.0, 0.999 * cut_on, cut_on, 1.2 * cut_on})
        EXPECT_LT(difference(c, kShares, {0, -1, -2, -3}, spread(f, 1.0 + 1e-5)), 1e-8) << f;
}

/// Two wheels in one bay: left to the elements.
TEST(PassingPositions, WheelsThatShareABay) {
    pem::CaseParameters c = tests::paper_case(3);
    c.track.spacing_m = 2.5;
    c.track.failed_fasteners = {{.every = 5}};
    EXPECT_LT(difference(c, {0.99}, {0, -1}, spread(20.0, 1.3)), kBoth);
}

/// The lines themselves: Fourier coefficients over the period, place by place and order by order, at half the frequency
/// of the line.
TEST(PassingLines, AreTheFourierCoefficientsOfTheDeflectionPlaceByPlace) {
    constexpr double kSpeed = 80.0 / 3.6;
    pem::CaseParameters c = tests::every_track_effect();
    c.track.failed_fasteners = {{.every = 3, .first_seat = 1}};
    const std::vector<pem::SpectralLine> lines = pem::passing_lines(c, vehicle::wheel_positions(c.vehicle), kSpeed);
    ASSERT_EQ(lines.size(), 12u);
    constexpr int kSamples = 36;
    for (const std::size_t m : {1u, 2u, 3u, 7u, 12u}) {
        const double frequency = static_cast<double>(m) * kSpeed / (3 * 0.6);
        EXPECT_DOUBLE_EQ(lines[m - 1].frequency_hz, frequency);
        std::array<Complex, 4> sum{};
        for (int k = 0; k < kSamples; ++k) {
            const std::vector<lanes::Complex> here =
                one_place(c, (k % 12) / 12.0, 1 - k / 12, spread(0.5 * frequency, 1.0));
            for (std::size_t i = 0; i < 4; ++i)
                sum[i] -= 2.0 * 80e3 / kSamples * here[i][0] *
                          std::polar(1.0, -2.0 * std::numbers::pi * static_cast<double>(m) * k / kSamples);
        }
        for (std::size_t i = 0; i < 4; ++i)
            EXPECT_NEAR(std::abs(lines[m - 1].amplitude_m[i] - sum[i]), 0.0, 1e-9 * std::abs(sum[i])) << m << ", " << i;
    }
}

}  // namespace
