// The convected rail against the residues of its polynomial dispersion relation (viscous foundation, Euler beam), whose roots
// are found here as eigenvalues of a companion matrix; and against its static and resting limits.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <complex>
#include <numbers>

#include "track/convected_rail.hpp"

namespace {

using namespace railpem;
using Complex = std::complex<double>;
constexpr Complex kI{0.0, 1.0};

constexpr double kEi = 2.06e11 * 3.22e-5, kMass = 60.64, kSpacing = 0.6;

/// 1/2π ∫ e^{ikx}/(EIk⁴ − m(ω − kv)² + (K + i(ω − kv)c)/L) dk = i·Σ residues with Im k > 0 (x ≥ 0), −i·Σ with Im k < 0 (x < 0).
Complex by_residues(double stiffness, double damping, double omega, double v, double x) {
    const Complex c0 = -kMass * omega * omega + (stiffness + kI * omega * damping) / kSpacing;
    const Complex c1 = 2.0 * kMass * omega * v - kI * v * damping / kSpacing;
    const Complex c2 = -kMass * v * v;
    Eigen::Matrix4cd companion = Eigen::Matrix4cd::Zero();
    companion(1, 0) = companion(2, 1) = companion(3, 2) = 1.0;
    companion(0, 3) = -c0 / kEi;
    companion(1, 3) = -c1 / kEi;
    companion(2, 3) = -c2 / kEi;
    const Eigen::Vector4cd roots = companion.eigenvalues();
    const double half = x >= 0.0 ? 1.0 : -1.0;
    Complex sum = 0.0;
    for (const Complex k : roots)
        if (half * k.imag() > 0.0) sum += half * kI * std::exp(kI * k * x) / (4.0 * kEi * k * k * k + 2.0 * c2 * k + c1);
    return sum;
}

track::ExactRail smeared(double damping) {
    track::TrackParameters track;
    track.rail = {.youngs_modulus_pa = 2.06e11, .second_moment_of_area_m4 = 3.22e-5, .mass_kg_per_m = kMass};
    track.pads.static_stiffness_n_per_m = 37.38e6;
    track.pads.damping_n_s_per_m = damping;
    return track::uniform_rail(track, {0.0}, 37.38e6);
}

class Convected : public testing::TestWithParam<double> {};

TEST_P(Convected, AgainstResidues) {
    const double damping = GetParam();
    const track::ExactRail rail = smeared(damping);
    const std::vector<double> separations{0.0, 2.4, -2.4, 15.6, -15.6, 20.4, -20.4};
    for (const double v : {10.0, 22.2222, 60.0})
        for (const double f : {1.0, 20.0, 57.6, 120.0, 400.0}) {
            const double omega = 2.0 * std::numbers::pi * f;
            const std::vector<Complex> change = track::convected_change(rail, 37.38e6, omega, v, separations);
            const double scale = std::abs(by_residues(37.38e6, damping, omega, 0.0, 0.0));
            for (std::size_t i = 0; i < separations.size(); ++i) {
                const Complex expected = by_residues(37.38e6, damping, omega, v, separations[i]) - by_residues(37.38e6, damping, omega, 0.0, separations[i]);
                EXPECT_NEAR(std::abs(change[i] - expected) / scale, 0.0, 1e-6) << f << " Hz, " << v << " m/s, x = " << separations[i];
            }
        }
}
INSTANTIATE_TEST_SUITE_P(Damping, Convected, testing::Values(7.5e4, 1.0e4));

/// The change is first order in the speed for a damped foundation and vanishes with it.
TEST(ConvectedRail, VanishesWithSpeed) {
    const track::ExactRail rail = smeared(7.5e4);
    EXPECT_EQ(track::convected_change(rail, 37.38e6, 300.0, 0.0, {0.0})[0], Complex(0.0));
    const double slow = std::abs(track::convected_change(rail, 37.38e6, 300.0, 0.1, {2.4})[0]);
    const double slower = std::abs(track::convected_change(rail, 37.38e6, 300.0, 0.01, {2.4})[0]);
    EXPECT_NEAR(slow / slower, 10.0, 0.05);
}

/// Reciprocity is lost, but for reversed motion it returns: R_ij(v) = R_ji(−v), so ahead and behind swap their difference sign to first order.
TEST(ConvectedRail, AheadAndBehindDiffer) {
    const track::ExactRail rail = smeared(7.5e4);
    const std::vector<Complex> change = track::convected_change(rail, 37.38e6, 360.0, 22.2, {2.4, -2.4});
    EXPECT_GT(std::abs(change[0] - change[1]), 0.5 * std::abs(change[0]));
}

}  // namespace
