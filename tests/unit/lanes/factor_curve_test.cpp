#include "lanes/factor_curve.hpp"

#include <gtest/gtest.h>

namespace railpem::lanes {
namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;
using Value = std::complex<double>;

FactorCurve two_nodes() { return {.frequency_hz = {4.0, 64.0}, .value = {{1.0, 0.2}, {2.0, -0.6}}}; }

TEST(FactorCurve, WithoutNodesIsOne) {
    EXPECT_TRUE(FactorCurve{}.empty());
    EXPECT_EQ(FactorCurve{}.at(300.0), Value(1.0));
    EXPECT_EQ(FactorCurve{}.at(-300.0), Value(1.0));
}

TEST(FactorCurve, LinearInTheLogarithmOfFrequencyAndConstantBeyond) {
    const FactorCurve curve = two_nodes();
    EXPECT_NEAR(std::abs(curve.at(kTwoPi * 16.0) - Value(1.5, -0.2)), 0.0, 1e-15);   // two octaves of four
    EXPECT_NEAR(std::abs(curve.at(kTwoPi * 8.0) - Value(1.25, 0.0)), 0.0, 1e-15);    // one octave of four
    for (const double f : {0.0, 1e-9, 3.9, 4.0}) EXPECT_EQ(curve.at(kTwoPi * f), Value(1.0, 0.2)) << f;
    for (const double f : {64.1, 1e6}) EXPECT_EQ(curve.at(kTwoPi * f), Value(2.0, -0.6)) << f;
}

TEST(FactorCurve, ARealMotionHasConjugatesAtNegativeFrequencies) {
    for (const double f : {1.0, 16.0, 100.0}) EXPECT_EQ(two_nodes().at(-kTwoPi * f), std::conj(two_nodes().at(kTwoPi * f))) << f;
}

TEST(FactorCurve, EveryLaneHasItsOwnFrequency) {
    const Real omega{-20.0, 5.0, 100.0, 1000.0};
    const Complex factor = two_nodes().at(omega);
    for (int lane = 0; lane < width; ++lane) EXPECT_EQ(factor[lane], two_nodes().at(omega[lane])) << lane;
}

}  // namespace
}  // namespace railpem::lanes
