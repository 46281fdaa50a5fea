#include "spectra/line_power.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace railpem::spectra {
namespace {

std::vector<double> uniform_grid(double from_hz, double step_hz, int lines) {
    std::vector<double> grid;
    for (int i = 0; i < lines; ++i) grid.push_back(from_hz + i * step_hz);
    return grid;
}

TEST(LinePower, SameWhateverTheGrid) {
    constexpr double power = 3.7e-3;
    for (const double deviation : {0.0, 1e-4, 0.02, 0.5})
        for (const double step : {0.01, 0.1, 0.37, 2.0})
            for (const double offset : {0.0, 0.31, 0.5, 0.99}) {
                // ±40 Hz around the line at 50 Hz: at least 80 deviations.
                const auto grid = uniform_grid(10.0 + offset * step, step, static_cast<int>(80.0 / step));
                double sum = 0.0;
                for (const double psd : line_psd(grid, 50.0, power, deviation)) sum += psd * step;
                // The step of the grid itself is rounded: 50 Hz·2⁻⁵³/0.01 Hz = 6e-13.
                EXPECT_NEAR(sum / power, 1.0, 1e-12) << deviation << " Hz, step " << step << ", offset " << offset;
            }
}

TEST(LinePower, SameOnUnevenGrids) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> jitter(0.2, 1.8);
    std::vector<double> grid = {10.0};
    while (grid.back() < 90.0) grid.push_back(grid.back() + 0.1 * jitter(random));
    const auto psd = line_psd(grid, 50.0, 2.0, 0.3);
    double sum = 0.0;
    for (std::size_t i = 1; i + 1 < grid.size(); ++i) sum += psd[i] * 0.5 * (grid[i + 1] - grid[i - 1]);
    EXPECT_NEAR(sum / 2.0, 1.0, 1e-12);
}

TEST(LinePower, FineGridShowsTheGaussian) {
    const auto grid = uniform_grid(49.0, 0.001, 2001);
    const auto psd = line_psd(grid, 50.0, 1.0, 0.1);
    for (const std::size_t i : {800u, 1000u, 1150u, 1300u}) {
        const double z = (grid[i] - 50.0) / 0.1;
        // The mean over a bin differs from its middle by step²/24·S''/S = 4e-6·(z² − 1) at most.
        EXPECT_NEAR(psd[i] * 0.1 * std::sqrt(2.0 * std::acos(-1.0)) / std::exp(-0.5 * z * z), 1.0, 4e-5);
    }
}

TEST(LinePower, TailsDoNotCancel) {
    // Φ(−10) − Φ(−11) = 7.6198530e-24 − 1.9106596e-28 (tables of the normal distribution); 1 − Φ loses it all.
    const double expected = 7.619853024160525e-24 - 1.9106595744986757e-28;
    EXPECT_NEAR(line_power_in_bin(10.0, 11.0, 0.0, 1.0, 1.0) / expected, 1.0, 1e-12);
    EXPECT_NEAR(line_power_in_bin(-11.0, -10.0, 0.0, 1.0, 1.0) / expected, 1.0, 1e-12);
}

TEST(LinePower, SharpLineBelongsToOneBin) {
    EXPECT_EQ(line_power_in_bin(1.0, 2.0, 2.0, 5.0, 0.0), 0.0);
    EXPECT_EQ(line_power_in_bin(2.0, 3.0, 2.0, 5.0, 0.0), 5.0);
}

TEST(LinePower, OnlyWhatLiesOnTheGridIsShown) {
    // The grid ends on the line: half of the power, and half a bin more (Gaussian density there).
    const auto grid = uniform_grid(40.0, 0.01, 1001);
    double sum = 0.0;
    for (const double psd : line_psd(grid, 50.0, 1.0, 1.0)) sum += psd * 0.01;
    EXPECT_NEAR(sum, 0.5 + 0.005 / std::sqrt(2.0 * std::acos(-1.0)), 1e-7);
}

}  // namespace
}  // namespace railpem::spectra
