// Friction that is not linearised: against one degree of freedom marched in time, and where it is weak.

#include "pem/distortion/realised_friction.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <unsupported/Eigen/FFT>

namespace railpem::pem {
namespace {

constexpr double kMass = 2000.0, kDamper = 2e4, kSpring = 2e6;  // 5 Hz
constexpr double kLineStep_hz = 0.5;
constexpr std::size_t kLineCount = 240, kExcited = 80;  // to 120 and 40 Hz
constexpr double kForcePsd = 2e5;                       // N²/Hz

/// A mass on spring and damper, pushed by random forces, with friction of `force`, linearised.
struct OneDegree {
    double force, damping;
    VelocitySpectra velocity{
        .from_hz = kLineStep_hz, .step_hz = kLineStep_hz, .elements = 1, .lines = kLineCount, .values = {}};
    ElementTransfers transfers{.from_hz = kLineStep_hz,
                               .step_hz = kLineStep_hz,
                               .lines = kLineCount,
                               .elements = 1,
                               .mobility = {},
                               .by_wheel = {}};
};

std::complex<double> mobility(double frequency, double damping) {
    const std::complex<double> s(0.0, 2.0 * std::numbers::pi * frequency);
    return 1.0 / (s * kMass + kDamper + damping + kSpring / s);
}

OneDegree one_degree(double force) {
    OneDegree own{.force = force, .damping = 0.0};
    for (int i = 0; i < 200; ++i) {
        double variance = 0.0;
        for (std::size_t k = 1; k <= kExcited; ++k)
            variance +=
                kForcePsd * kLineStep_hz * std::norm(mobility(kLineStep_hz * static_cast<double>(k), own.damping));
        own.damping = 0.5 * own.damping + 0.5 * force * std::sqrt(2.0 / std::numbers::pi / variance);
    }
    for (std::size_t k = 1; k <= kLineCount; ++k) {
        own.transfers.mobility.push_back(mobility(kLineStep_hz * static_cast<double>(k), own.damping));
        own.velocity.values.push_back(k <= kExcited ? kForcePsd * std::norm(own.transfers.mobility.back()) : 0.0);
    }
    return own;
}

/// c·σ²: what the linearised damper takes.
double excited(const OneDegree& own) {
    double sum = 0.0;
    for (const std::complex<double>& psd : own.velocity.values) sum += own.damping * psd.real() * kLineStep_hz;
    return sum;
}

/// Means of what the force has beyond c·v: its power, and times v_0.
struct Means {
    double power = 0.0, followed = 0.0;
};

Means of_curves(const OneDegree& own, const RealisedFriction& found) {
    const std::vector<std::complex<double>> gaussian = friction_distortion(own.velocity, own.force);
    Means means;
    for (std::size_t k = 0; k < kLineCount; ++k) {
        const double omega = 2.0 * std::numbers::pi * kLineStep_hz * static_cast<double>(k + 1),
                     excited = own.damping * own.velocity.values[k].real() * kLineStep_hz;
        const std::complex<double> damping = found.damping.at(omega);
        means.power += std::norm(damping) * own.damping * excited +
                       found.power.at(omega).real() * gaussian[k].real() * kLineStep_hz;
        means.followed += damping.real() * excited;
    }
    return means;
}

constexpr std::size_t kSteps = 16384;  ///< of a period

/// Forces of a draw and the velocities that they cause in the linearised system.
struct Draw {
    std::vector<double> push = std::vector<double>(kSteps, 0.0);
    /// amplitudes of its lines
    std::vector<std::complex<double>> linear = std::vector<std::complex<double>>(kExcited + 1);
};

Draw draw_of(const OneDegree& own, std::mt19937& random) {
    std::normal_distribution<double> normal;
    Draw draw;
    for (std::size_t k = 1; k <= kExcited; ++k) {
        const double scale = std::sqrt(kForcePsd * kLineStep_hz);
        const std::complex<double> amplitude(scale * normal(random), scale * normal(random)),
            turn = std::polar(1.0, 2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(kSteps));
        draw.linear[k] = own.transfers.mobility[k - 1] * amplitude;
        std::complex<double> phase = 1.0;
        for (std::size_t t = 0; t < kSteps; ++t, phase *= turn) draw.push[t] += (amplitude * phase).real();
    }
    return draw;
}

/// What the force has beyond c·v, by implicit Euler, in which the velocity at a step's end is what friction lets pass
/// of it; the second of two periods.
std::vector<double> beyond_of(const OneDegree& own, const Draw& draw) {
    constexpr double kStep_s = 1.0 / kLineStep_hz / kSteps, kInertia = kMass / kStep_s + kDamper + kSpring * kStep_s;
    std::vector<double> beyond(kSteps);
    double v = 0.0, u = 0.0;
    for (std::size_t t = 0; t < 2 * kSteps; ++t) {
        const double asked = kMass / kStep_s * v - kSpring * u + draw.push[t % kSteps];
        v = std::copysign(std::max(0.0, std::abs(asked) - own.force), asked) / kInertia;
        u += v * kStep_s;
        beyond[t % kSteps] = asked - kInertia * v - own.damping * v;
    }
    return beyond;
}

/// Of the lines of the spectra.
Means marched(const OneDegree& own, int draws) {
    std::mt19937 random(7);
    Eigen::FFT<double> transform;
    Means means;
    for (int i = 0; i < draws; ++i) {
        const Draw draw = draw_of(own, random);
        std::vector<std::complex<double>> lines;
        transform.fwd(lines, beyond_of(own, draw));
        for (std::size_t k = 1; k <= kLineCount; ++k) {
            const std::complex<double> amplitude = lines[k] * (2.0 / kSteps);
            means.power += 0.5 * std::norm(amplitude) / draws;
            if (k <= kExcited) means.followed += 0.5 * (amplitude * std::conj(draw.linear[k])).real() / draws;
        }
    }
    return means;
}

class RealisedFrictionOf : public testing::TestWithParam<double> {};

// With eight seeds of 200 draws of 2 s each the power lay within 6 % of the marched one (3000 N; 2.5 % at 500 and 1500
// N), and what follows within 0.036 of the damping's.
TEST_P(RealisedFrictionOf, IsThatOfAMarchedMass) {
    const OneDegree own = one_degree(GetParam());
    const Means found = of_curves(own, realised_friction(own.velocity, own.transfers, {own.damping}, own.force,
                                                         {.realisations = 200})),
                expected = marched(own, 200);
    EXPECT_NEAR(found.power, expected.power, 0.08 * expected.power);
    EXPECT_NEAR(found.followed / excited(own), expected.followed / excited(own), 0.05);
}

INSTANTIATE_TEST_SUITE_P(Forces, RealisedFrictionOf, testing::Values(500.0, 1500.0, 3000.0));

TEST(RealisedFriction, IsItsLinearisationWhereItIsWeak) {
    const OneDegree own = one_degree(50.0);
    ASSERT_LT(own.damping, 0.1 * kDamper);
    const Means means = of_curves(own, realised_friction(own.velocity, own.transfers, {own.damping}, own.force)),
                gaussian = of_curves(own, {.damping = {{1.0}, {0.0}}, .power = {{1.0}, {1.0}}});
    EXPECT_NEAR(means.followed / excited(own), 0.0, 0.05);            // -0.014 to 0.024 in eight seeds
    EXPECT_NEAR(means.power, gaussian.power, 0.05 * gaussian.power);  // 0.998 to 1.031 in eight seeds
}

// A force that stops the mass most of the time has forces beside its damping that linearisation does not know.
TEST(RealisedFriction, HasMorePowerWhereItIsStrong) {
    const OneDegree own = one_degree(3000.0);
    const Means means = of_curves(own, realised_friction(own.velocity, own.transfers, {own.damping}, own.force)),
                gaussian = of_curves(own, {.damping = {{1.0}, {0.0}}, .power = {{1.0}, {1.0}}});
    EXPECT_GT(means.power, 2.0 * gaussian.power);  // 2.26 to 2.45 in eight seeds, 2.33 marched
}

TEST(RealisedFriction, IsTheSameAgain) {
    const OneDegree own = one_degree(1500.0);
    const RealisedFriction once = realised_friction(own.velocity, own.transfers, {own.damping}, own.force,
                                                    {.realisations = 3}),
                           again = realised_friction(own.velocity, own.transfers, {own.damping}, own.force,
                                                     {.realisations = 3});
    EXPECT_EQ(once.power.value, again.power.value);
    EXPECT_EQ(once.damping.value, again.damping.value);
}

}  // namespace
}  // namespace railpem::pem
