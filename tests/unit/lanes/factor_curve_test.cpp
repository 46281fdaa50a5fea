#include "lanes/factor_curve.hpp"
#include "tests/unit/lanes/in_turn.hpp"

#include <gtest/gtest.h>

namespace railpem::lanes {
namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;
using Value = std::complex<double>;

FactorCurve two_nodes() {
    return {.frequency_hz = {4.0, 64.0}, .value = {{1.0, 0.2}, {2.0, -0.6}}};
}

TEST(FactorCurve, WithoutNodesIsOne) {
    EXPECT_TRUE(FactorCurve{}.empty());
    EXPECT_EQ(FactorCurve{}.at(300.0), Value(1.0));
    EXPECT_EQ(FactorCurve{}.at(-300.0), Value(1.0));
}

TEST(FactorCurve, LinearInTheLogarithmOfFrequencyAndConstantBeyond) {
    const FactorCurve curve = two_nodes();
    EXPECT_NEAR(std::abs(curve.at(kTwoPi * 16.0) - Value(1.5, -0.2)), 0.0, 1e-15);  // two octaves of four
    EXPECT_NEAR(std::abs(curve.at(kTwoPi * 8.0) - Value(1.25, 0.0)), 0.0, 1e-15);   // one octave of four
    for (const double f : {0.0, 1e-9, 3.9, 4.0}) EXPECT_EQ(curve.at(kTwoPi * f), Value(1.0, 0.2)) << f;
    for (const double f : {64.1, 1e6}) EXPECT_EQ(curve.at(kTwoPi * f), Value(2.0, -0.6)) << f;
}

TEST(FactorCurve, FollowsAParabolaExactly) {
    const auto parabola = [](double f) {
        const double x = std::log(f);
        return Value(1.0 - 0.3 * x + 0.2 * x * x, 0.5 * x - 0.1 * x * x);
    };
    FactorCurve curve{.frequency_hz = {2.0, 5.0, 9.0, 40.0, 175.0}, .value = {}};
    for (const double f : curve.frequency_hz) curve.value.push_back(parabola(f));
    for (double f = 2.0; f < 175.0; f *= 1.07)
        EXPECT_NEAR(std::abs(curve.at(kTwoPi * f) - parabola(f)), 0.0, 1e-13) << f;
}

TEST(FactorCurve, ARealMotionHasConjugatesAtNegativeFrequencies) {
    for (const double f : {1.0, 16.0, 100.0})
        EXPECT_EQ(two_nodes().at(-kTwoPi * f), std::conj(two_nodes().at(kTwoPi * f))) << f;
}

TEST(FactorCurve, EveryLaneHasItsOwnFrequency) {
    const Real omega = tests::in_turn({-20.0, 5.0, 100.0, 1000.0});
    const Complex factor = two_nodes().at(omega);
    for (int lane = 0; lane < width; ++lane) EXPECT_EQ(factor[lane], two_nodes().at(omega[lane])) << lane;
}

}  // namespace
}  // namespace railpem::lanes
