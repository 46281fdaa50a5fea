// The Gaussian estimate of EN 12299's 95th percentile against the definition: a long random vibration, its rms over
// consecutive 5 s, their 95th percentile.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <kissfft/kissfft.hh>
#include <numbers>
#include <random>
#include <vector>

#include "spectra/comfort.hpp"
#include "spectra/frequency_weighting.hpp"

namespace railpem::spectra {
namespace {

// A body on its suspension at 1 Hz (narrow: 15 % damping) with some vibration up to 30 Hz.
double acceleration_psd(double f) {
    if (f > 90.0) return 0.0;
    const double r = f;
    return 0.01 / (std::pow(1.0 - r * r, 2) + std::pow(2.0 * 0.15 * r, 2)) + 2e-4 / (1.0 + std::pow(f / 10.0, 4));
}

TEST(ComfortPercentile, IsThatOfALongRandomVibration) {
    constexpr double rate_hz = 204.8;
    constexpr std::size_t samples = 1 << 21;  // 10240 s: 2048 values
    constexpr double duration_s = static_cast<double>(samples) / rate_hz;
    std::mt19937_64 random(3);
    std::normal_distribution<double> normal;
    std::vector<std::complex<double>> lines(samples), vibration(samples);
    for (std::size_t k = 1; k < samples / 2; ++k) {
        const double f = static_cast<double>(k) / duration_s;
        const double deviation = std::sqrt(acceleration_psd(f) / duration_s) * weighting_wb(f);
        lines[k] = std::complex<double>(normal(random), normal(random)) * deviation;
    }
    kissfft<double>(samples, true).transform(lines.data(), vibration.data());
    std::vector<double> values;
    constexpr std::size_t block = 1024;  // 5 s
    for (std::size_t start = 0; start + block <= samples; start += block) {
        double sum = 0.0;
        for (std::size_t i = start; i < start + block; ++i) sum += std::pow(vibration[i].real(), 2);
        values.push_back(std::sqrt(sum / block));
    }
    const std::size_t place = values.size() * 95 / 100;
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(place), values.end());
    const double counted = values[place];

    std::vector<double> frequency, psd;
    for (double f = 0.3; f <= 90.0; f += 0.02) {
        frequency.push_back(f);
        psd.push_back(acceleration_psd(f));
    }
    const auto estimate = vertical_comfort_en12299(frequency, psd);
    ASSERT_TRUE(estimate);
    EXPECT_GT(estimate->degrees_of_freedom, 4.0);
    EXPECT_LT(estimate->degrees_of_freedom, 30.0);  // few enough that the spread matters
    // Standard error of a 95th percentile of N values: √(0.05·0.95/N)/density, density at 1.645 deviations 0.103/s,
    // s = rms/√(2ν): 0.047·rms/√(2ν) for N = 2048. Three of them, and 1 % for a scaled χ² in place of the law of a sum
    // of unequally strong lines: over 20 records made with NumPy the estimate is 0.9 % low (0.1243 against
    // 0.1254 ± 0.0002 m/s²).
    const double standard_error =
        0.047 * estimate->weighted_rms_m_per_s2 / std::sqrt(2.0 * estimate->degrees_of_freedom);
    EXPECT_NEAR(estimate->percentile_95_m_per_s2, counted,
                3.0 * standard_error + 0.01 * estimate->percentile_95_m_per_s2);
}

}  // namespace
}  // namespace railpem::spectra
