#include "spectra/comfort.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "spectra/frequency_weighting.hpp"

namespace railpem::spectra {
namespace {

struct Pair {
    double frequency_hz, value;
};

TEST(WeightingWk, TabulatedValuesOfIso2631) {
    // ISO 2631-1:1997, principal weighting W_k in thousandths at the nominal frequencies 0.5 to 80 Hz.
    constexpr std::array<Pair, 23> table = {
        {{0.5, 418},  {0.63, 459}, {0.8, 477},  {1.0, 482},  {1.25, 484}, {1.6, 494}, {2.0, 531},  {2.5, 631},
         {3.15, 804}, {4.0, 967},  {5.0, 1039}, {6.3, 1054}, {8.0, 1036}, {10, 988},  {12.5, 902}, {16, 768},
         {20, 636},   {25, 513},   {31.5, 405}, {40, 314},   {50, 246},   {63, 186},  {80, 132}}};
    // One unit of the last printed digit: 21 of the 23 agree to half a unit, 484 and 768 of the table are the filter's
    // 484.5 and 768.7 cut off.
    for (const Pair& row : table)
        EXPECT_NEAR(1000.0 * weighting_wk(row.frequency_hz), row.value, 1.0) << row.frequency_hz << " Hz";
    EXPECT_EQ(weighting_wk(0.0), 0.0);
}

TEST(WeightingWb, IndependentEvaluation) {
    // The transfer function of EN 12299:2009 multiplied out in rad/s with NumPy; 1e-12 for rounding.
    constexpr std::array<Pair, 7> table = {{{0.4, 0.2819931009306868},
                                            {1.0, 0.39107681744626155},
                                            {2.0, 0.4366753951612319},
                                            {5.0, 0.9570329246453562},
                                            {8.0, 1.055925305159046},
                                            {16.0, 0.9182523822708989},
                                            {50.0, 0.3239009091924748}}};
    for (const Pair& row : table) EXPECT_NEAR(weighting_wb(row.frequency_hz) / row.value, 1.0, 1e-12);
}

TEST(WeightingSperling, IndependentEvaluation) {
    constexpr std::array<Pair, 4> table = {{{1.0, 0.4891251062806939},
                                            {5.4, 0.8120066106444387},
                                            {10.0, 0.4929715871701465},
                                            {30.0, 0.13745215226068147}}};
    for (const Pair& row : table) EXPECT_NEAR(weighting_sperling_vertical(row.frequency_hz) / row.value, 1.0, 1e-12);
}

// A triangular peak of the mean square `power` at centre_hz on a grid from low_hz to high_hz, so narrow that a
// weighting is constant over it.
struct Peak {
    std::vector<double> frequency, psd;
};
Peak narrow_peak(double centre_hz, double power, double low_hz = 0.4, double high_hz = 100.0) {
    constexpr double width = 1e-4;
    return {{low_hz, centre_hz - width, centre_hz, centre_hz + width, high_hz}, {0.0, 0.0, power / width, 0.0, 0.0}};
}

TEST(WeightedRms, NarrowPeakIsWeightedAtItsFrequency) {
    const auto peak = narrow_peak(5.0, 0.04);
    // Only the line at the centre carries power: the result is exact but for rounding of f ± 1e-4.
    EXPECT_NEAR(*weighted_rms_iso2631(peak.frequency, peak.psd), 0.2 * weighting_wk(5.0), 1e-10);
}

TEST(SperlingIndex, SineOfTheOriginalFormula) {
    // W_z = (a³B³)^0.1 with the peak a in cm/s²: a sine of 10 cm/s² at 5.4 Hz has a mean square of 0.5·0.1² (m/s²)².
    const auto peak = narrow_peak(5.4, 0.5 * 0.1 * 0.1);
    const double original = std::pow(std::pow(10.0, 3) * std::pow(0.8120066106444387, 3), 0.1);
    EXPECT_NEAR(*sperling_index_vertical(peak.frequency, peak.psd), original, 1e-10);
    // What lies above 30 Hz does not count.
    const auto high = narrow_peak(50.0, 1.0);
    EXPECT_EQ(*sperling_index_vertical(high.frequency, high.psd), 0.0);
}

TEST(Comfort, NoValueWithoutTheFrequencies) {
    const std::vector<double> psd = {1.0, 1.0};
    const std::vector<double> late = {0.6, 100.0}, early = {0.3, 79.0}, short_of_sperling = {0.3, 29.0};
    EXPECT_FALSE(weighted_rms_iso2631(late, psd));
    EXPECT_FALSE(weighted_rms_iso2631(early, psd));
    EXPECT_FALSE(vertical_comfort_en12299(early, psd));
    EXPECT_FALSE(sperling_index_vertical(short_of_sperling, psd));
    EXPECT_TRUE(sperling_index_vertical(early, psd));
}

TEST(VerticalComfort, NarrowBandHasTwoDegreesOfFreedom) {
    // Vibration much narrower than 1/T keeps its amplitude over 5 s: its mean square is that of a Rayleigh amplitude,
    // χ² with two degrees of freedom, 95th percentile −ln 0.05 of the mean.
    const auto peak = narrow_peak(5.03, 0.04);
    const auto comfort = vertical_comfort_en12299(peak.frequency, peak.psd);
    EXPECT_NEAR(comfort->degrees_of_freedom, 2.0, 1e-9);
    // 0.5 %: the approximation of Wilson and Hilferty at ν = 2.
    EXPECT_NEAR(comfort->percentile_95_m_per_s2 / (comfort->weighted_rms_m_per_s2 * std::sqrt(-std::log(0.05))), 1.0,
                0.005);
    EXPECT_DOUBLE_EQ(comfort->mean_comfort, 6.0 * comfort->percentile_95_m_per_s2);
}

TEST(VerticalComfort, FlatBandHasTwiceBandwidthTimesDuration) {
    // Weighted flat over B = 100 Hz: ν = 2BT = 1000 for T = 5 s.
    std::vector<double> frequency, psd;
    for (int i = 0; i <= 2000; ++i) {
        frequency.push_back(0.4 + 0.05 * i);
        psd.push_back(1.0 / std::pow(weighting_wb(frequency.back()), 2));
    }
    const auto comfort = vertical_comfort_en12299(frequency, psd);
    EXPECT_NEAR(comfort->weighted_rms_m_per_s2, 10.0, 1e-10);
    // Where the band ends one side of the kernel is missing: with N = 1000 bins of 0.1 Hz, 2N²/(N + 2·Σ (N − k)(2/πk)²)
    // over odd k < N is 1001.863 (summed with Python). 1e-6: its digits.
    EXPECT_NEAR(comfort->degrees_of_freedom / 1001.863, 1.0, 1e-6);
}

TEST(VerticalComfort, StillnessIsComfortable) {
    const std::vector<double> frequency = {0.4, 100.0}, psd = {0.0, 0.0};
    EXPECT_EQ(vertical_comfort_en12299(frequency, psd)->mean_comfort, 0.0);
}

}  // namespace
}  // namespace railpem::spectra
