#include "track/rail/modal_rail.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>

#include "parameters/parameter_error.hpp"
#include "tests/unit/track/wei2016_track.hpp"
#include "track/elements/rail_damper.hpp"
#include "track/pads/pad_positions.hpp"

namespace railpem::track {
namespace {

using std::numbers::pi;
using Complex = std::complex<double>;

ModalRail paper_rail(const TrackParameters& track, int modes = 120) {
    return modal_rail(track, pad_positions(track, wei2016_wheels_m, wei2016_pads), wei2016_wheels_m, modes);
}

/// Pads that differ, so that nothing is symmetric by accident.
Eigen::VectorXcd uneven_pads() {
    Eigen::VectorXcd pads(wei2016_pads);
    for (int j = 0; j < pads.size(); ++j) pads[j] = Complex(40e6 + 1e6 * j, 10e6 + 2e5 * ((7 * j) % 13));
    return pads;
}

TEST(ModalRail, ReceptanceIsReciprocalAndDissipative) {
    const ModalRail rail = paper_rail(wei2016_track());
    for (const double f : {0.3, 57.6, 200.0}) {
        const ModalReceptance found = modal_receptance(rail, f, uneven_pads());
        const Eigen::MatrixXcd& r = found.at_points;
        EXPECT_LE((r - r.transpose()).cwiseAbs().maxCoeff(),
                  1e-11 * r.cwiseAbs().maxCoeff());  // condition of D, 1e5 or less
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> loss(-r.imag());
        EXPECT_GT(loss.eigenvalues().minCoeff(), 0.0) << "every force pattern must lose power in the pads";
    }
}

/// Power put in by forces at the wheels = power lost in the pads: Im(F^H w) summed on both sides, per line.
TEST(ModalRail, PowerBalances) {
    const ModalRail rail = paper_rail(wei2016_track());
    const Eigen::VectorXcd pads = uneven_pads();
    for (const double f : {2.0, 57.6, 180.0}) {
        const ModalReceptance found = modal_receptance(rail, f, pads);
        for (int j = 0; j < 4; ++j) {
            const double lost = (pads.imag().array() * found.at_pads.col(j).cwiseAbs2().array()).sum();
            EXPECT_NEAR(-found.at_points(j, j).imag() / lost, 1.0, 1e-10);
        }
    }
}

TEST(ModalRail, TrackbedForceIsTheSumOfThePads) {
    const ModalRail rail = paper_rail(wei2016_track());
    const Eigen::VectorXcd pads = uneven_pads();
    const ModalReceptance found = modal_receptance(rail, 40.0, pads);
    for (int j = 0; j < 4; ++j)
        EXPECT_NEAR(std::abs(found.trackbed[j] - (pads.array() * found.at_pads.col(j).array()).sum()), 0.0, 1e-12);
    // At low frequency nothing but the pads holds the force; 1e-3 of it goes into the simply supported ends (e^{-7.8
    // m·β}).
    const ModalReceptance quasi_static = modal_receptance(rail, 0.01, Eigen::VectorXcd::Constant(wei2016_pads, 37.4e6));
    for (int j = 0; j < 4; ++j) EXPECT_NEAR(quasi_static.trackbed[j].real(), 1.0, 1e-3);
}

TEST(ModalRail, WithoutPadsTheNaturalFrequenciesOfTheSimplySupportedBeam) {
    const TrackParameters track = wei2016_track();
    const ModalRail rail = paper_rail(track, 3);
    const double length = 61 * 0.6;
    for (int n = 1; n <= 3; ++n)
        EXPECT_NEAR(rail.circular_frequency_rad_per_s[n - 1],
                    std::pow(n * pi / length, 2) * std::sqrt(2.06e11 * 3.22e-5 / 60.64), 1e-12);
}

TEST(ModalRail, PointsMayStandAtPads) {
    const ModalRail rail = paper_rail(wei2016_track());
    const ModalReceptance found = modal_receptance(rail, 60.0, uneven_pads());
    EXPECT_NEAR(std::abs(found.at_pads(47, 0) - found.at_points(0, 0)), 0.0, 1e-12 * std::abs(found.at_points(0, 0)));
}

/// A rigidly attached damper (far above its mass's motion) only adds mass: the same as a heavier rail of equal
/// stiffness.
TEST(ModalRail, StiffDampersAreMass) {
    TrackParameters damped = wei2016_track(), heavy = wei2016_track();
    damped.rail_dampers = {{10.0, 1e6, 0.0}};
    heavy.rail.mass_kg_per_m += 10.0;
    const Eigen::MatrixXcd a = modal_receptance(paper_rail(damped), 90.0, uneven_pads()).at_points;
    const Eigen::MatrixXcd b = modal_receptance(paper_rail(heavy), 90.0, uneven_pads()).at_points;
    EXPECT_LE((a - b).cwiseAbs().maxCoeff(),
              1e-7 * b.cwiseAbs().maxCoeff());  // (90 Hz/1 MHz)² = 8e-9 of a mass ratio of 1/7
}

TEST(RailDamper, DynamicMass) {
    const std::vector<RailDamper> damper{{10.0, 500.0, 0.35}};
    EXPECT_NEAR(std::abs(damper_mass_kg_per_m(damper, 0.01) - 10.0), 0.0, 1e-8);
    const Complex at_resonance = damper_mass_kg_per_m(damper, 500.0);  // m(1 + iη)/(iη)
    EXPECT_NEAR(std::abs(at_resonance - 10.0 * Complex(1.0, 0.35) / Complex(0.0, 0.35)), 0.0, 1e-12);
    for (const double f : {100.0, 500.0, 900.0})
        EXPECT_LT(damper_mass_kg_per_m(damper, f).imag(), 0.0) << "−ω²m dissipates";
    EXPECT_NEAR(damper_mass_kg_per_m({{10.0, 500.0, 0.35}, {5.0, 900.0, 0.2}}, 0.01).real(), 15.0, 1e-7);
}

TEST(ModalRail, RailLossTakesPowerToo) {
    TrackParameters track = wei2016_track();
    track.rail.loss_factor = 0.02;
    const Eigen::VectorXcd elastic = Eigen::VectorXcd::Constant(wei2016_pads, 37.4e6);
    EXPECT_LT(modal_receptance(paper_rail(track), 60.0, elastic).at_points(0, 0).imag(), 0.0);
    EXPECT_NEAR(modal_receptance(paper_rail(wei2016_track()), 60.0, elastic).at_points(0, 0).imag(), 0.0, 1e-18);
}

TEST(ModalRail, RefusesWhatItCannotDo) {
    TrackParameters track = wei2016_track();
    EXPECT_THROW(paper_rail(track, 0), parameters::ParameterError);
    EXPECT_THROW(modal_rail(track, pad_positions(track, wei2016_wheels_m, 21), wei2016_wheels_m, 10),
                 parameters::ParameterError);
    track.rail.beam = Beam::timoshenko;
    EXPECT_THROW(paper_rail(track), parameters::ParameterError);
}

}  // namespace
}  // namespace railpem::track
