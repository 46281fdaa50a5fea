#include "track/pads/support_law.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "tests/unit/track/wei2016_track.hpp"
#include "track/statics/seat_stiffness.hpp"

namespace railpem::track {
namespace {

using Complex = std::complex<double>;

SupportParameters ballast() {
    return {SupportModel::two_layer, 150.0, 60e6, 60e3, 0.1, {}};
}

TEST(SupportLaw, RigidGroundDoesNotMove) {
    EXPECT_EQ(support_receptance({}, 50.0), 0.0);
    EXPECT_EQ(static_support_compliance({}), 0.0);
    const Complex pad(40e6, 5e6);
    EXPECT_EQ(support_stiffness(pad, 0.0), pad);
}

TEST(SupportLaw, FailedPadOnAnySupportCarriesNothing) {
    EXPECT_EQ(support_stiffness(0.0, support_receptance(ballast(), 50.0)), 0.0);
}

/// Pad, sleeper and ballast as a chain of two degrees of freedom, condensed to the rail.
TEST(SupportLaw, SeriesIsTheCondensedChain) {
    const double f = 87.0, omega = 2.0 * std::numbers::pi * f;
    const SupportParameters support = ballast();
    const Complex pad(40e6, 9e6), spring(60e6, 6e6 + omega * 60e3);
    Eigen::Matrix2cd chain;
    chain << pad, -pad, -pad, pad + spring - omega * omega * 150.0;
    const Complex expected = 1.0 / chain.inverse()(0, 0);
    EXPECT_NEAR(std::abs(support_stiffness(pad, support_receptance(support, f)) / expected - 1.0), 0.0, 1e-13);
}

/// A sleeper with one bending mode: rigid and modal coordinate, uniform ballast couples neither with the other.
TEST(SupportLaw, BendingModeAddsItsOwnDegreeOfFreedom) {
    const double f = 140.0, omega = 2.0 * std::numbers::pi * f, omega_n = 2.0 * std::numbers::pi * 120.0;
    SupportParameters support = ballast();
    support.bending_modes = {{120.0, 0.02, 80.0}};
    const Complex pad(40e6, 9e6), spring(60e6, 6e6 + omega * 60e3);
    Eigen::Matrix3cd chain;    // rail, rigid sleeper, mode: the seat moves by the sum of the last two
    chain << pad, -pad, -pad,  //
        -pad, pad + spring - omega * omega * 150.0, pad,  //
        -pad, pad, pad + 80.0 * (omega_n * omega_n * Complex(1.0, 0.02) - omega * omega) + spring * 80.0 / 150.0;
    const Complex expected = 1.0 / chain.inverse()(0, 0);
    EXPECT_NEAR(std::abs(support_stiffness(pad, support_receptance(support, f)) / expected - 1.0), 0.0, 1e-13);
}

TEST(SupportLaw, StaticComplianceIsTheLowFrequencyLimit) {
    SupportParameters support = ballast();
    support.loss_factor = 0.0;
    support.bending_modes = {{120.0, 0.0, 80.0}};
    const double rest = static_support_compliance(support);
    EXPECT_NEAR(support_receptance(support, 1e-5).real() / rest, 1.0, 1e-10);
}

TEST(SeatStiffness, FailureTakesItsShareOfSpringAndDashpot) {
    TrackParameters track = wei2016_track();
    const double f = 60.0;
    const Complex whole = seat_stiffness(track, 40e6, 1.0, f);
    EXPECT_NEAR(std::abs(whole - Complex(40e6 * std::pow(15.0, 0.15), 2.0 * std::numbers::pi * 60.0 * 7.5e4)), 0.0,
                1e-6);
    EXPECT_NEAR(std::abs(seat_stiffness(track, 40e6, 0.3, f) - 0.3 * whole), 0.0, 1e-6);
    track.support = ballast();
    const Complex below = support_receptance(track.support, f);
    EXPECT_NEAR(std::abs(1.0 / seat_stiffness(track, 40e6, 1.0, f) - 1.0 / whole - below), 0.0, 1e-20);
}

}  // namespace
}  // namespace railpem::track
