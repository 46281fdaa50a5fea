#include "recordings/estimates/order_track.hpp"

#include <array>
#include <cassert>
#include <cmath>
#include <numbers>
#include <numeric>

#include "recordings/estimates/confidence.hpp"
#include "recordings/estimates/window.hpp"

namespace railpem::recordings {

OrderTrack track_order(const std::vector<double>& samples, double sampling_rate_hz,
                       const std::vector<double>& speed_m_per_s, double wheel_radius_m, double order, double window_s) {
    assert(samples.size() == speed_m_per_s.size() && wheel_radius_m > 0.0);
    constexpr double two_pi = 2.0 * std::numbers::pi;
    OrderTrack track;
    track.order = order;
    std::vector<double> angle(samples.size());  // of the order, rad
    double turned = 0.0;
    for (std::size_t n = 0; n < samples.size(); ++n) {
        angle[n] = turned;
        turned += order * speed_m_per_s[n] / wheel_radius_m / sampling_rate_hz;
    }
    const auto length = static_cast<std::size_t>(window_s * sampling_rate_hz);
    if (length < 16 || samples.size() < length) return track;
    const std::vector<double> window = window_samples(Window::hann, length);
    const double sum = std::accumulate(window.begin(), window.end(), 0.0),
                 energy = std::inner_product(window.begin(), window.end(), window.begin(), 0.0);
    constexpr std::array<double, 5> beside = {0.0, -3.0, -2.0, 2.0,
                                              3.0};  // bins; the Hann window is zero at its second one
    double at_order = 0.0, around = 0.0, windows = 0.0;
    for (std::size_t begin = 0; begin + length <= samples.size(); begin += length / 2, windows += 1.0) {
        std::array<std::complex<double>, beside.size()> values{};
        for (std::size_t n = 0; n < length; ++n) {
            const double x = samples[begin + n];
            if (!std::isfinite(x)) continue;
            const std::complex<double> turned_back = window[n] * x * std::polar(1.0, -angle[begin + n]);
            values[0] += turned_back;
            for (std::size_t b = 1; b < beside.size(); ++b)
                values[b] += turned_back * std::polar(1.0, -two_pi * beside[b] * static_cast<double>(n) /
                                                               static_cast<double>(length));
        }
        track.time_s.push_back((static_cast<double>(begin) + 0.5 * static_cast<double>(length)) / sampling_rate_hz);
        track.frequency_hz.push_back((angle[begin + length - 1] - angle[begin]) / two_pi /
                                     (static_cast<double>(length - 1) / sampling_rate_hz));
        track.amplitude.push_back(2.0 * values[0] / sum);
        at_order += std::norm(values[0]);
        for (std::size_t b = 1; b < beside.size(); ++b) around += 0.25 * std::norm(values[b]);
    }
    at_order /= windows;
    around /= windows;
    track.background = 2.0 * around / (sampling_rate_hz * energy);
    track.mean_square = std::max(0.0, 2.0 * (at_order - around) / (sum * sum));
    // Half overlapped Hann windows: 0.947 of them are independent; the background has about 2.5 independent neighbours
    // of its four.
    const double degrees = 2.0 * 0.947 * windows;
    track.false_alarm = around > 0.0 ? f_exceeded(at_order / around, degrees, 2.5 * degrees) : 1.0;
    return track;
}

}  // namespace railpem::recordings
