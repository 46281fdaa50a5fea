#include "spectra/profile_spectrum.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <complex>
#include <kissfft/kissfft.hh>
#include <numbers>

#include "parameters/parameter_error.hpp"

namespace railpem::spectra {

namespace {

constexpr std::size_t fewest_samples = 16;

[[noreturn]] void refuse(const char* problem, const char* allowed) {
    throw parameters::ParameterError("irregularity.profile", problem, allowed);
}

double even_step(std::span<const double> position_m, std::span<const double> height_m) {
    if (position_m.size() != height_m.size())
        refuse("as many positions as heights are needed", "columns of one length");
    if (position_m.size() < fewest_samples) refuse("the profile is too short", "at least 16 samples");
    const double step = (position_m.back() - position_m.front()) / static_cast<double>(position_m.size() - 1);
    for (std::size_t i = 0; i < position_m.size(); ++i) {
        if (!std::isfinite(position_m[i]) || !std::isfinite(height_m[i]))
            refuse("a position or height is not a finite number", "finite numbers");
        if (i > 0 && !(std::abs(position_m[i] - position_m[i - 1] - step) <= 0.01 * step))
            refuse("the positions do not increase in even steps", "steps within 1 % of their mean");
    }
    return step;
}

// The largest even length up to `longest` without a prime factor above 5: the transform stays O(N log N).
std::size_t quick_length(std::size_t longest) {
    for (std::size_t length = longest - longest % 2;; length -= 2) {
        std::size_t rest = length;
        for (const std::size_t prime : {2u, 3u, 5u})
            while (rest % prime == 0) rest /= prime;
        if (rest == 1) return length;
    }
}

std::vector<double> hann_window(std::size_t length) {
    std::vector<double> window(length);
    for (std::size_t i = 0; i < length; ++i)
        window[i] = 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(length));
    return window;
}

// Values minus their least-squares straight line.
std::vector<double> without_straight_line(std::span<const double> values) {
    const auto count = static_cast<double>(values.size());
    const double middle = 0.5 * (count - 1.0);
    double mean = 0.0, moment = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        mean += values[i] / count;
        moment += values[i] * (static_cast<double>(i) - middle);
    }
    const double slope = moment / (count * (count * count - 1.0) / 12.0);
    std::vector<double> result(values.size());
    for (std::size_t i = 0; i < values.size(); ++i)
        result[i] = values[i] - mean - slope * (static_cast<double>(i) - middle);
    return result;
}

// Welch (1967), with the correlation (1/6)² of Hann-windowed segments overlapping by half.
double independent_averages(int segments) {
    const double k = segments;
    return k * k / (k + 2.0 * (k - 1.0) / 36.0);
}

}  // namespace

ProfileSpectrum spectrum_of_profile(std::span<const double> position_m, std::span<const double> height_m,
                                    double segment_length_m) {
    const double step = even_step(position_m, height_m);
    // Asked of the heights: after the straight line is removed from a constant, rounding remains.
    const auto [lowest, highest] = std::minmax_element(height_m.begin(), height_m.end());
    if (*lowest == *highest) refuse("the profile does not vary", "measured heights");
    const double wanted = std::floor(segment_length_m / step * (1.0 + 1e-9));  // a length of whole steps stays whole
    if (!(wanted >= static_cast<double>(fewest_samples) && wanted <= static_cast<double>(height_m.size())))
        refuse("the segments cannot be cut from the profile", "a segment length from 16 steps to the whole profile");
    const std::size_t length = quick_length(static_cast<std::size_t>(wanted));
    const std::vector<double> window = hann_window(length);
    double window_power = 0.0;
    for (const double weight : window) window_power += weight * weight;

    ProfileSpectrum spectrum;
    spectrum.segment_length_m = static_cast<double>(length) * step;
    std::vector<double> sum(length / 2, 0.0);
    kissfft<double> transform(length, false);
    std::vector<std::complex<double>> segment(length), lines(length);
    for (std::size_t start = 0; start + length <= height_m.size(); start += length / 2, ++spectrum.segments) {
        const std::vector<double> heights = without_straight_line(height_m.subspan(start, length));
        for (std::size_t i = 0; i < length; ++i) segment[i] = heights[i] * window[i];
        transform.transform(segment.data(), lines.data());
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += std::norm(lines[i]);
    }
    for (std::size_t i = 2; i < sum.size(); ++i) {
        spectrum.cycles_per_m.push_back(static_cast<double>(i) / spectrum.segment_length_m);
        spectrum.psd_m3.push_back(2.0 * step / window_power * sum[i] / spectrum.segments);
    }
    spectrum.averages = independent_averages(spectrum.segments);
    return spectrum;
}

IrregularityBand measured_band(const ProfileSpectrum& spectrum) {
    assert(spectrum.cycles_per_m.size() >= 2);
    return {.family = Family::table,
            .shortest_wavelength_m = 1.0 / spectrum.cycles_per_m.back(),
            .longest_wavelength_m = 1.0 / spectrum.cycles_per_m.front(),
            .table_cycles_per_m = spectrum.cycles_per_m,
            .table_psd_m3 = spectrum.psd_m3};
}

}  // namespace railpem::spectra
