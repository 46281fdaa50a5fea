#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "recordings/estimates/fourier_transform.hpp"
#include "recordings/estimates/wheelbase_speed.hpp"
#include "synthetic_record.hpp"

namespace railpem::recordings {
namespace {

using testing::geometry;
using testing::make_record;

/// White noise and the same delayed by any number of seconds (periodic), with noise added to both.
std::pair<std::vector<double>, std::vector<double>> delayed_pair(double delay_s, double noise, unsigned seed) {
    const std::size_t length = 32768;
    const double rate = 1000.0;
    const FourierTransform transform(length);
    std::mt19937_64 generator(seed);
    std::normal_distribution<double> normal;
    std::vector<double> a(length), b(length);
    for (double& x : a) x = normal(generator);
    std::vector<std::complex<double>> spectrum(transform.bins());
    transform.forward(a.data(), spectrum.data());
    for (std::size_t k = 0; k < spectrum.size(); ++k)
        spectrum[k] *= std::polar(
            1.0, -2.0 * std::numbers::pi * static_cast<double>(k) * rate / static_cast<double>(length) * delay_s);
    transform.inverse(spectrum.data(), b.data());
    for (double& x : a) x += noise * normal(generator);
    for (double& x : b) x += noise * normal(generator);
    return {a, b};
}

TEST(Delay, IsFoundWithinItsStatedErrorForFractionsOfASample) {
    int within = 0, trials = 60;
    double worst = 0.0;
    for (int trial = 0; trial < trials; ++trial) {
        const double delay = 0.1 + 0.000137 * trial;
        const auto [a, b] = delayed_pair(delay, 1.0, 100U + static_cast<unsigned>(trial));
        const Delay found = estimate_delay(a, b, 1000.0, {.least_s = -1.0, .most_s = 1.0});
        ASSERT_TRUE(found.found);
        EXPECT_FALSE(found.inverted);
        const double error = (found.seconds - delay) / found.standard_error_s;
        worst = std::max(worst, std::abs(error));
        within += std::abs(error) < 1.645 ? 1 : 0;
    }
    // 90 % of 60, less three standard deviations of a binomial count (2.3 each).
    EXPECT_GE(within, 47);
    EXPECT_LT(worst, 4.5);
}

TEST(Delay, TellsInvertedChannels) {
    auto [a, b] = delayed_pair(0.0312, 0.5, 7);
    for (double& x : b) x = -x;
    const Delay found = estimate_delay(a, b, 1000.0, {.least_s = -0.5, .most_s = 0.5});
    ASSERT_TRUE(found.found);
    EXPECT_TRUE(found.inverted);
    EXPECT_NEAR(found.seconds, 0.0312, 5.0 * found.standard_error_s);
}

TEST(Delay, IsNotFoundBetweenUnrelatedChannels) {
    int found = 0;
    for (unsigned seed = 0; seed < 40; ++seed) {
        const auto first = delayed_pair(0.1, 1.0, 1000 + seed).first;
        const auto second = delayed_pair(0.1, 1.0, 2000 + seed).first;
        found += estimate_delay(first, second, 1000.0).found ? 1 : 0;
    }
    EXPECT_EQ(found, 0);
}

TEST(WheelbaseSpeed, IsWithinTwoTenthsOfAPercent) {
    for (unsigned seed = 1; seed <= 10; ++seed) {
        const double speed = 15.0 + 4.37 * seed;
        const Recording recording = make_record({.speed_m_per_s = speed, .seed = seed});
        const auto found = wheelbase_speed(wheelbase_delays(recording.series, geometry(), {}));
        ASSERT_TRUE(found.has_value()) << speed;
        EXPECT_NEAR(found->speed_m_per_s / speed, 1.0, 0.002) << speed << " ± " << found->standard_error_m_per_s;
        EXPECT_NEAR(found->speed_m_per_s, speed, 5.0 * found->standard_error_m_per_s) << speed;
        EXPECT_GE(found->pairs_used, 3);
        RecordProperty("speed_" + std::to_string(seed), std::to_string(found->speed_m_per_s / speed - 1.0));
    }
}

}  // namespace
}  // namespace railpem::recordings
