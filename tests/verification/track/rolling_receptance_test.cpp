// Wheels that roll over seats against what shares no code with them: the residues of the dispersion relation of a rail
// on a bed, its roots eigenvalues of a companion matrix; the mean over resting wheels; the deflection under constant
// loads.

#include "track/rail/rolling_receptance.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <complex>
#include <numbers>

#include "../pem/paper_case.hpp"
#include "ballasted_track.hpp"
#include "track/rail/exact_rail.hpp"
#include "track/statics/rolling_pads.hpp"

namespace {

using namespace railpem;
using namespace std::complex_literals;
using Complex = std::complex<double>;

constexpr double kEi = 2.06e11 * 3.22e-5, kMass = 60.64;
const std::vector<double> kWheels{0.0, -2.4, -9.1};

/// 1/2π ∫ e^{ikx}/(EIk⁴ − m(ω − kv)² + (K + i(ω − kv)c)/L) dk = i·Σ residues with Im k > 0 (x ≥ 0), −i·Σ with Im k < 0
/// (x < 0).
Complex by_residues(double stiffness, double damping, double spacing, double omega, double v, double x) {
    const Complex c0 = -kMass * omega * omega + (stiffness + 1.0i * omega * damping) / spacing;
    const Complex c1 = 2.0 * kMass * omega * v - 1.0i * v * damping / spacing;
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
        if (half * k.imag() > 0.0)
            sum += half * 1.0i * std::exp(1.0i * k * x) / (4.0 * kEi * k * k * k + 2.0 * c2 * k + c1);
    return sum;
}

/// Order m of the receptances of resting wheels over a bay, `places` of them.
std::vector<Complex> resting(const track::TrackParameters& track, double pad, double frequency, int order, int places) {
    std::vector<Complex> mean(kWheels.size() * kWheels.size());
    for (int k = 0; k < places; ++k) {
        std::vector<double> moved = kWheels;
        for (double& wheel : moved) wheel += track.spacing_m * k / places;
        const track::ExactRail rail = track::uniform_rail(track, moved, pad);
        track::ExactRailWorkspace workspace(rail);
        const track::RailReceptance& at =
            track::rail_receptance(rail, lanes::broadcast(2.0 * std::numbers::pi * frequency), workspace);
        for (std::size_t i = 0; i < mean.size(); ++i)
            mean[i] += at.between[i][0] * std::polar(1.0 / places, -2.0 * std::numbers::pi * order * k / places);
    }
    return mean;
}

double dynamic_pad(const track::TrackParameters& track) {
    return track.pads.dynamic_to_static_ratio * track.pads.static_stiffness_n_per_m;
}

// Seats every 2 cm are a bed. Measured: 2.2e-5 of the receptance at the force, the periodic images on either side
// (rolling_receptance.hpp).
TEST(RollingReceptance, DenseSeatsAreABed) {
    for (const double damping : {10e3, 75e3}) {
        track::TrackParameters track;
        track.rail = {.youngs_modulus_pa = 2.06e11, .second_moment_of_area_m4 = 3.22e-5, .mass_kg_per_m = kMass};
        track.spacing_m = 0.02;
        track.pads.static_stiffness_n_per_m = 37.38e6 * track.spacing_m / 0.6;
        track.pads.dynamic_to_static_ratio = 1.0;
        track.pads.damping_n_s_per_m = damping * track.spacing_m / 0.6;
        for (const double speed : {10.0, 33.0, 60.0})
            for (const double f : {5.0, 40.0, 100.0, 200.0}) {
                const auto rolling =
                    track::rolling_receptance(track, track.pads.static_stiffness_n_per_m, kWheels, speed, f, 0);
                const double omega = 2.0 * std::numbers::pi * f;
                const auto expected = [&](double x) {
                    return by_residues(track.pads.static_stiffness_n_per_m, track.pads.damping_n_s_per_m,
                                       track.spacing_m, omega, speed, x);
                };
                for (std::size_t i = 0; i < kWheels.size(); ++i)
                    for (std::size_t j = 0; j < kWheels.size(); ++j)
                        EXPECT_LT(std::abs(rolling.at(0, i, j) - expected(kWheels[i] - kWheels[j])),
                                  3e-5 * std::abs(expected(0.0)))
                            << speed << " m/s, " << f << " Hz, " << i << j;
            }
    }
}

// Wheels that crawl at 0.02 m/s: every order is that of resting ones. Measured: 7.3e-5 of the receptance at the force,
// what the rule leaves of the sum over n on a rail that shears; 5e-6 on one that bends. Between wheels what the speed
// changes: five times as much at 0.1 m/s.
TEST(RollingReceptance, SlowWheelsMeetRestingOnes) {
    constexpr double kSlow = 0.02;
    for (const track::TrackParameters& track : {tests::paper_case(1).track, track::ballasted_track()})
        for (const double f : {30.0, 90.0, 170.0}) {
            const auto rolling = track::rolling_receptance(track, dynamic_pad(track), kWheels, kSlow, f, 2);
            const double scale = std::abs(rolling.at(0, 0, 0));
            for (const int order : {0, 1, 2, -1}) {
                const std::vector<Complex> mean = resting(track, dynamic_pad(track), f, order, 24);
                for (std::size_t i = 0; i < kWheels.size(); ++i)
                    for (std::size_t j = 0; j < kWheels.size(); ++j)
                        EXPECT_LT(std::abs(rolling.at(order, i, j) - mean[i * kWheels.size() + j]), 1e-4 * scale)
                            << f << " Hz, order " << order << ", " << i << j;
            }
        }
}

// A force that hardly changes is a constant load: its orders are those of the deflection under rolling wheels
// (rolling_pads.hpp, by the histories of the pads).
TEST(RollingReceptance, ConstantLoadsSinkAsTheyRoll) {
    constexpr double kLoad = 80e3;
    for (const track::Beam beam : {track::Beam::euler, track::Beam::timoshenko}) {
        track::TrackParameters track = tests::paper_case(1).track;
        track.rail.beam = beam;
        for (const double speed : {15.0, 33.0}) {
            const auto rolling = track::rolling_receptance(track, dynamic_pad(track), kWheels, speed, 0.01, 2);
            const auto history = track::pad_history(track, kWheels, kLoad, speed);
            const auto sunk = track::rolling_deflection(track, kWheels, speed, history, 2);
            for (int m = 1; m <= 2; ++m)
                for (std::size_t wheel = 0; wheel < kWheels.size(); ++wheel) {
                    Complex sum = 0.0;
                    for (std::size_t j = 0; j < kWheels.size(); ++j) sum += kLoad * rolling.at(m, wheel, j);
                    EXPECT_NEAR(std::abs(sum / sunk[static_cast<std::size_t>(m - 1) * kWheels.size() + wheel] - 1.0),
                                0.0, 1e-3)
                        << speed << " m/s, order " << m;
                }
        }
    }
}

// What all pads carry, in the mean over a bay. Measured: 1.9e-5.
TEST(RollingReceptance, TrackbedIsTheMeanOfRestingOnes) {
    const track::TrackParameters track = track::ballasted_track();
    for (const double f : {20.0, 80.0, 150.0}) {
        Complex mean = 0.0;
        for (int k = 0; k < 24; ++k) {
            const track::ExactRail rail = track::uniform_rail(track, {track.spacing_m * k / 24.0}, dynamic_pad(track));
            track::ExactRailWorkspace workspace(rail);
            mean +=
                track::rail_receptance(rail, lanes::broadcast(2.0 * std::numbers::pi * f), workspace).trackbed[0][0] /
                24.0;
        }
        EXPECT_NEAR(std::abs(track::rolling_trackbed(track, dynamic_pad(track),
                                                     lanes::broadcast(2.0 * std::numbers::pi * f))[0] /
                                 mean -
                             1.0),
                    0.0, 5e-5)
            << f;
    }
}

}  // namespace
