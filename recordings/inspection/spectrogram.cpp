#include "recordings/inspection/spectrogram.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "recordings/estimates/fourier_transform.hpp"

namespace railpem::recordings {
namespace {

double power_of(const std::vector<double>& samples) {
    double sum = 0.0;
    for (const double x : without_trend(samples))
        if (std::isfinite(x)) sum += x * x;
    return sum;
}

Spectrogram spectrogram(const Channel& channel, double rate) {
    constexpr std::size_t most_times = 400, most_bins = 300;
    Spectrogram result;
    result.channel = channel.description.name;
    const std::vector<double> samples = without_trend(channel.samples);
    const std::size_t length =
        std::min(fast_length(static_cast<std::size_t>(rate)), samples.size() - samples.size() % 2);
    if (length < 32) return result;
    const std::size_t hop = std::max<std::size_t>(length / 4, (samples.size() - length) / most_times + 1);
    const FourierTransform transform(length);
    const std::vector<double> window = window_samples(Window::hann, length);
    const double energy = std::inner_product(window.begin(), window.end(), window.begin(), 0.0);
    const auto usable = static_cast<std::size_t>(std::min(0.4 * rate, 500.0) / rate * static_cast<double>(length));
    const std::size_t joined = usable / most_bins + 1;
    result.window_s = static_cast<double>(length) / rate;
    result.step_s = static_cast<double>(hop) / rate;
    result.bin_hz = static_cast<double>(joined) * rate / static_cast<double>(length);
    result.bins = usable / joined;
    std::vector<double> segment(length);
    std::vector<std::complex<double>> spectrum(transform.bins());
    for (std::size_t begin = 0; begin + length <= samples.size(); begin += hop, ++result.times) {
        for (std::size_t n = 0; n < length; ++n) segment[n] = window[n] * samples[begin + n];
        transform.forward(segment.data(), spectrum.data());
        for (std::size_t b = 0; b < result.bins; ++b) {
            double sum = 0.0;
            for (std::size_t k = 0; k < joined; ++k)
                sum += 2.0 * std::norm(spectrum[b * joined + k]) / (rate * energy * static_cast<double>(joined));
            result.level_db.push_back(std::isfinite(sum) ? static_cast<float>(10.0 * std::log10(std::max(sum, 1e-30)))
                                                         : std::numeric_limits<float>::quiet_NaN());
        }
    }
    return result;
}

}  // namespace

std::vector<Spectrogram> spectrograms_of(const TimeSeries& series) {
    std::map<Location, std::pair<double, const Channel*>> roughest;
    for (const Channel& channel : series.channels) {
        const double power = power_of(channel.samples);
        auto& entry = roughest[channel.description.location];
        if (!entry.second || power > entry.first) entry = {power, &channel};
    }
    std::vector<Spectrogram> result;
    for (const Location location : {Location::wheel, Location::rail, Location::bogie, Location::body, Location::none})
        if (const auto found = roughest.find(location); found != roughest.end() && result.size() < 3) {
            Spectrogram picture = spectrogram(*found->second.second, series.sampling_rate_hz);
            if (picture.times > 0 && picture.bins > 0) result.push_back(std::move(picture));
        }
    return result;
}

}  // namespace railpem::recordings
