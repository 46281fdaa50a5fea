#include "spectra/third_octaves.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "spectra/integrate_psd.hpp"

namespace railpem::spectra {
namespace {

TEST(ThirdOctaveBand, CentresAndEdges) {
    // Exact mid-band frequencies and edges of IEC 61260-1:2014, base ten, to five digits.
    const auto hundred = third_octave_band(20);
    EXPECT_DOUBLE_EQ(hundred.centre_hz, 100.0);
    EXPECT_NEAR(third_octave_band(15).centre_hz, 31.623, 5e-4);
    EXPECT_NEAR(third_octave_band(14).centre_hz, 25.119, 5e-4);
    EXPECT_NEAR(hundred.low_hz, 89.125, 5e-4);
    EXPECT_NEAR(hundred.high_hz, 112.20, 5e-3);
}

TEST(ThirdOctaveBand, NominalNames) {
    constexpr std::array names = {0.25, 0.315, 0.4,  0.5,  0.63, 0.8,  1.0,  1.25, 1.6,  2.0,  2.5,  3.15,
                                  4.0,  5.0,   6.3,  8.0,  10.0, 12.5, 16.0, 20.0, 25.0, 31.5, 40.0, 50.0,
                                  63.0, 80.0,  100., 125., 160., 200., 250., 315., 400., 500., 630., 800.};
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto band = third_octave_band(static_cast<int>(i) - 6);
        EXPECT_EQ(band.nominal_hz, names[i]);
        EXPECT_NEAR(band.centre_hz / band.nominal_hz, 1.0, 0.013);  // names differ by up to 1.3 % from the centres
    }
}

TEST(ThirdOctaveBand, NeighboursShareTheirEdge) {
    for (int index = -10; index < 40; ++index)
        EXPECT_EQ(third_octave_band(index).high_hz, third_octave_band(index + 1).low_hz);
}

TEST(ThirdOctaveBands, OnlyWholeBands) {
    const auto bands = third_octave_bands(0.3, 200.0);
    EXPECT_EQ(bands.front().nominal_hz, 0.4);   // 0.315 begins at 0.282
    EXPECT_EQ(bands.back().nominal_hz, 160.0);  // 200 ends at 224
    const auto edge = third_octave_band(7);
    ASSERT_EQ(third_octave_bands(edge.low_hz, edge.high_hz).size(), 1u);
    EXPECT_TRUE(third_octave_bands(edge.low_hz * 1.0001, edge.high_hz).empty());
}

TEST(ThirdOctaveLevels, WhiteNoiseOnAnUnevenGrid) {
    // Constant S: each band's mean square is S·(high − low), whatever the grid.
    std::vector<double> frequency, psd;
    for (double f = 0.9; f < 120.0; f *= 1.137) frequency.push_back(f);
    psd.assign(frequency.size(), 4e-3);
    const auto levels = third_octave_levels(frequency, psd);
    EXPECT_EQ(levels.front().band.nominal_hz, 1.25);
    for (const auto& level : levels) {
        const double power = 4e-3 * (level.band.high_hz - level.band.low_hz);
        EXPECT_NEAR(level.mean_square / power, 1.0, 1e-13);
        EXPECT_NEAR(level.level_db, 10.0 * std::log10(power) + 120.0, 1e-10);
    }
}

TEST(ThirdOctaveLevels, PartialIntervalsAreExactForLinearPsd) {
    // S = f on a coarse grid: ∫ = (high² − low²)/2.
    const std::vector<double> frequency = {1.0, 7.0, 7.5, 30.0};
    for (const auto& level : third_octave_levels(frequency, frequency)) {
        const double expected = 0.5 * (std::pow(level.band.high_hz, 2) - std::pow(level.band.low_hz, 2));
        EXPECT_NEAR(level.mean_square / expected, 1.0, 1e-13);
    }
}

TEST(ThirdOctaveLevels, NothingHasMinusInfinity) {
    const std::vector<double> frequency = {1.0, 10.0}, psd = {0.0, 0.0};
    EXPECT_EQ(third_octave_levels(frequency, psd).front().level_db, -std::numeric_limits<double>::infinity());
}

TEST(MeanSquare, NoValueOutsideTheGrid) {
    const std::vector<double> frequency = {1.0, 2.0, 4.0}, psd = {1.0, 3.0, 3.0};
    EXPECT_FALSE(mean_square_between(frequency, psd, 0.9, 2.0));
    EXPECT_FALSE(mean_square_between(frequency, psd, 1.0, 4.1));
    EXPECT_DOUBLE_EQ(*mean_square_between(frequency, psd, 1.0, 4.0), 8.0);
    EXPECT_DOUBLE_EQ(*mean_square_between(frequency, psd, 1.5, 1.75), 0.25 * 2.25);
    EXPECT_EQ(*mean_square_between(frequency, psd, 2.0, 2.0), 0.0);
    EXPECT_DOUBLE_EQ(root_mean_square(frequency, psd), std::sqrt(8.0));
}

}  // namespace
}  // namespace railpem::spectra
