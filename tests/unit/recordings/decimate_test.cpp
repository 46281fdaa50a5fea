#include "recordings/estimates/decimate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace railpem::recordings {
namespace {

constexpr double rate = 25600.0, highest = 2000.0;

std::vector<double> tone(double frequency_hz, std::size_t samples) {
    std::vector<double> x;
    for (std::size_t n = 0; n < samples; ++n)
        x.push_back(std::cos(2.0 * std::numbers::pi * frequency_hz * static_cast<double>(n) / rate));
    return x;
}

TEST(Decimate, LeavesOrdinaryRatesAlone) {
    for (const double ordinary : {200.0, 1000.0, 2000.0, 5000.0, 9999.0})
        EXPECT_EQ(decimation_factor(ordinary, highest), 1U) << ordinary;
    EXPECT_EQ(decimation_factor(rate, highest), 5U);
    EXPECT_EQ(decimated({1.0, 2.0}, 1000.0, 1, highest), (std::vector<double>{1.0, 2.0}));
}

TEST(Decimate, KeepsWhatLiesBelowAndItsTime) {
    const std::vector<double> x = tone(1990.0, 6000), y = decimated(x, rate, 5, highest);
    ASSERT_EQ(y.size(), 1200U);
    for (std::size_t m = 100; m < 1100; ++m) EXPECT_NEAR(y[m], x[5 * m], 2e-5);  // 100 dB of either side
}

TEST(Decimate, LetsNothingFoldBackBelow) {
    for (const double above : {3130.0, 5120.0, 7000.0, 12000.0})
        for (std::size_t m = 100; const double value : decimated(tone(above, 6000), rate, 5, highest))
            if (m++ > 200 && m < 1100) {
                EXPECT_LT(std::abs(value), 2e-5) << above;
            }
}

TEST(Decimate, KeepsAConstantUpToTheEndsAndAGapWhereItIs) {
    std::vector<double> x(4000, 3.0);
    for (const double value : decimated(x, rate, 5, highest)) EXPECT_NEAR(value, 3.0, 1e-12);
    x[2000] = std::numeric_limits<double>::quiet_NaN();
    const std::vector<double> y = decimated(x, rate, 5, highest);
    EXPECT_TRUE(std::isnan(y[400]));
    EXPECT_NEAR(y[360], 3.0, 1e-12);
    EXPECT_NEAR(y[440], 3.0, 1e-12);
}

}  // namespace
}  // namespace railpem::recordings
