#include "spectra/line_power.hpp"

#include <cassert>
#include <cmath>
#include <numbers>

namespace railpem::spectra {

double line_power_in_bin(double low_hz, double high_hz, double line_hz, double power, double deviation_hz) {
    assert(low_hz <= high_hz && deviation_hz >= 0.0);
    if (deviation_hz == 0.0) return low_hz <= line_hz && line_hz < high_hz ? power : 0.0;
    // erfc(27.3) is below the smallest number there is: farther off, the line leaves exactly nothing.
    const double farthest = 27.3 * std::numbers::sqrt2 * deviation_hz;
    if (low_hz - line_hz > farthest || line_hz - high_hz > farthest) return 0.0;
    const double low = (low_hz - line_hz) / (std::numbers::sqrt2 * deviation_hz);
    const double high = (high_hz - line_hz) / (std::numbers::sqrt2 * deviation_hz);
    // On one side of the line the difference of two values near ±1 would cancel: erfc is small there.
    if (low > 0.0) return 0.5 * power * (std::erfc(low) - std::erfc(high));
    if (high < 0.0) return 0.5 * power * (std::erfc(-high) - std::erfc(-low));
    return 0.5 * power * (std::erf(high) - std::erf(low));
}

std::vector<double> line_psd(std::span<const double> frequency_hz, double line_hz, double power, double deviation_hz) {
    const std::size_t lines = frequency_hz.size();
    assert(lines >= 2);
    // Every inner edge is computed once and belongs to both of its bins: no gap, no overlap.
    std::vector<double> edges(lines + 1);
    for (std::size_t i = 1; i < lines; ++i) edges[i] = 0.5 * (frequency_hz[i - 1] + frequency_hz[i]);
    edges.front() = 2.0 * frequency_hz.front() - edges[1];
    edges.back() = 2.0 * frequency_hz.back() - edges[lines - 1];
    std::vector<double> psd(lines);
    for (std::size_t i = 0; i < lines; ++i)
        psd[i] = line_power_in_bin(edges[i], edges[i + 1], line_hz, power, deviation_hz) / (edges[i + 1] - edges[i]);
    return psd;
}

}  // namespace railpem::spectra
