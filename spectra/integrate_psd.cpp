#include "spectra/integrate_psd.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace railpem::spectra {

double mean_square(std::span<const double> frequency_hz, std::span<const double> psd) {
    return *mean_square_between(frequency_hz, psd, frequency_hz.front(), frequency_hz.back());
}

double root_mean_square(std::span<const double> frequency_hz, std::span<const double> psd) {
    return std::sqrt(mean_square(frequency_hz, psd));
}

std::optional<double> mean_square_between(std::span<const double> frequency_hz, std::span<const double> psd,
                                          double low_hz, double high_hz) {
    const auto f = frequency_hz;
    assert(!f.empty() && f.size() == psd.size() && low_hz <= high_hz);
    if (low_hz < f.front() || high_hz > f.back()) return std::nullopt;
    double sum = 0.0;
    const auto first = static_cast<std::size_t>(std::upper_bound(f.begin(), f.end(), low_hz) - f.begin());
    for (std::size_t i = std::max<std::size_t>(first, 1); i < f.size() && f[i - 1] < high_hz; ++i) {
        const double from = std::max(low_hz, f[i - 1]);
        const double to = std::min(high_hz, f[i]);
        // A line's value at the middle is the mean of a linear piece.
        const double middle = (0.5 * (from + to) - f[i - 1]) / (f[i] - f[i - 1]);
        sum += (to - from) * (psd[i - 1] + middle * (psd[i] - psd[i - 1]));
    }
    return sum;
}

}  // namespace railpem::spectra
