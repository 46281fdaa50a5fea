#include "spectra/frequency_weighting.hpp"

#include <cmath>
#include <complex>
#include <numbers>

namespace railpem::spectra {

namespace {

struct VerticalWeighting {
    double transition_hz, transition_quality;
    double step_from_hz, step_from_quality;
    double step_to_hz, step_to_quality;
    double gain;  // of the step at low frequencies
};

// 1 + s/(Q·f0) + (s/f0)², s = if.
std::complex<double> second_order(std::complex<double> s, double f0, double quality) {
    return 1.0 + s / (quality * f0) + s * s / (f0 * f0);
}

double magnitude(const VerticalWeighting& w, double frequency_hz) {
    constexpr double high_pass_hz = 0.4;
    constexpr double low_pass_hz = 100.0;
    constexpr double butterworth = 1.0 / std::numbers::sqrt2;
    const std::complex<double> s(0.0, frequency_hz);
    const auto high_pass = s * s / (high_pass_hz * high_pass_hz) / second_order(s, high_pass_hz, butterworth);
    const auto low_pass = 1.0 / second_order(s, low_pass_hz, butterworth);
    const auto transition = (1.0 + s / w.transition_hz) / second_order(s, w.transition_hz, w.transition_quality);
    const auto step = w.gain * second_order(s, w.step_from_hz, w.step_from_quality) /
                      second_order(s, w.step_to_hz, w.step_to_quality);
    return std::abs(high_pass * low_pass * transition * step);
}

}  // namespace

double weighting_wk(double frequency_hz) {
    // The step of ISO 2631-1 (eq. A.4) ends at 1 for high frequencies: its gain at low ones is (f5/f6)².
    constexpr double from = 2.37;
    constexpr double to = 3.35;
    return magnitude({12.5, 0.63, from, 0.91, to, 0.91, (from / to) * (from / to)}, frequency_hz);
}

double weighting_wb(double frequency_hz) {
    return magnitude({16.0, 0.63, 2.5, 0.8, 4.0, 0.8, 0.4}, frequency_hz);
}

double weighting_sperling_vertical(double frequency_hz) {
    const double f = frequency_hz;
    const double f2 = f * f;
    const double numerator = 1.911 * f2 + std::pow(0.25 * f2, 2);
    const double denominator = std::pow(1.0 - 0.277 * f2, 2) + std::pow(1.563 * f - 0.0368 * f2 * f, 2);
    return 0.588 * std::sqrt(numerator / denominator);
}

}  // namespace railpem::spectra
