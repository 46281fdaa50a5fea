#include "spectra/rail_joint_lines.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace railpem::spectra {
namespace {

using std::numbers::pi;

// (2/L) ∫ z(x) cos(2πmx/L) dx by the trapezoidal rule over the dip. The integrand is smooth and its first derivative is
// zero at the ends of the dip: the error falls with the fourth power of the step.
double amplitude_by_quadrature(const RailJoints& joints, int order) {
    constexpr int intervals = 20000;
    double sum = 0.0;
    for (int i = 0; i <= intervals; ++i) {
        const double x = joints.length_m * (static_cast<double>(i) / intervals - 0.5);
        const double dip = -0.5 * joints.depth_m * (1.0 + std::cos(2.0 * pi * x / joints.length_m));
        sum += dip * std::cos(2.0 * pi * order * x / joints.spacing_m);
    }
    return 2.0 / joints.spacing_m * sum * joints.length_m / intervals;
}

TEST(RailJointLines, ClosedFormIsTheFourierIntegral) {
    const RailJoints joints{.spacing_m = 25.0, .depth_m = 0.5e-3, .length_m = 1.0};
    for (const int order : {1, 2, 7, 12, 13, 24, 26, 40, 100})
        // (π·order/25/intervals)⁴-like errors are below rounding of 20000 terms, 1e-13 of the largest amplitude.
        EXPECT_NEAR(joint_line_amplitude_m(joints, order), amplitude_by_quadrature(joints, order), 1e-13 * 2e-5)
            << "order " << order;
}

TEST(RailJointLines, FiniteWhereTheDipIsOnePeriod) {
    const RailJoints joints{.spacing_m = 25.0, .depth_m = 0.5e-3, .length_m = 1.0};
    EXPECT_DOUBLE_EQ(joint_line_amplitude_m(joints, 25), -0.5e-3 * 1.0 / (2.0 * 25.0));
}

TEST(RailJointLines, PowersAddUpToTheVariance) {
    const RailJoints joints{.spacing_m = 10.0, .depth_m = 1e-3, .length_m = 2.0};
    double lines = 0.0;
    for (int order = 1; order <= 500; ++order) lines += 0.5 * std::pow(joint_line_amplitude_m(joints, order), 2);
    // Parseval: mean square 3/8·h²·l/L minus the squared mean (h·l/(2L))². Amplitudes fall as order⁻³: the lines
    // above order 500 hold less than 1e-10 of it.
    const double duty = joints.length_m / joints.spacing_m;
    const double variance = joints.depth_m * joints.depth_m * (0.375 * duty - 0.25 * duty * duty);
    EXPECT_NEAR(lines / variance, 1.0, 1e-10);
}

}  // namespace
}  // namespace railpem::spectra
