// Powers and circular functions of lanes against the library's, one number at a time.

#include "lanes/elementary_lanes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace railpem::lanes {
namespace {

constexpr double kRound = 1e-15;  // a few units in the last place of numbers around one

TEST(ElementaryLanes, Logarithm) {
    for (double x = 1e-12; x < 1e12; x *= 1.0371)
        EXPECT_NEAR(log(broadcast(x))[1], std::log(x), kRound * std::max(1.0, std::abs(std::log(x)))) << x;
    EXPECT_EQ(log(broadcast(1.0))[0], 0.0);
}

TEST(ElementaryLanes, Exponential) {
    for (double x = -600.0; x < 600.0; x += 0.3771)
        EXPECT_NEAR(exp(broadcast(x))[2] / std::exp(x), 1.0, kRound * std::max(1.0, std::abs(x))) << x;
    EXPECT_EQ(exp(broadcast(0.0))[3], 1.0);
}

TEST(ElementaryLanes, Power) {
    for (const double exponent : {0.15, 1.0, -0.4, 2.5})
        for (double x = 1e-8; x < 1e8; x *= 1.37)
            EXPECT_NEAR(power(broadcast(x), exponent)[0] / std::pow(x, exponent), 1.0, 1e-13) << x;
    EXPECT_EQ(power(broadcast(7.0), 0.0)[0], 1.0);
}

TEST(ElementaryLanes, Circle) {
    for (double x = -1e4; x < 1e4; x += 1.2347) {
        const std::complex<double> value = unit(broadcast(x))[0];
        EXPECT_NEAR(value.real(), std::cos(x), kRound * std::max(1.0, std::abs(x))) << x;
        EXPECT_NEAR(value.imag(), std::sin(x), kRound * std::max(1.0, std::abs(x))) << x;
    }
}

/// Every lane goes its own way.
TEST(ElementaryLanes, LanesAreIndependent) {
    const Real x{0.3, 40.0, 2e-5, 7.0};
    const Complex circle = unit(-x);
    const Real powers = power(x, 0.15);
    for (int lane = 0; lane < width; ++lane) {
        EXPECT_NEAR(circle[lane].real(), std::cos(x[lane]), 1e-14);
        EXPECT_NEAR(circle[lane].imag(), -std::sin(x[lane]), 1e-14);
        EXPECT_NEAR(powers[lane], std::pow(x[lane], 0.15), 1e-14);
    }
}

}  // namespace
}  // namespace railpem::lanes
