#include "recordings/estimates/cross_spectra.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <numeric>

#include "parameters/parameter_error.hpp"
#include "recordings/estimates/fourier_transform.hpp"
#include "recordings/units.hpp"

namespace railpem::recordings {
namespace {

using Complex = std::complex<double>;

/// Sums of X_i X_j* over segments, kept as one row of bins per pair i ≥ j: the inner loop runs along memory.
class PairSums {
  public:
    PairSums(std::size_t channels, std::size_t bins)
        : channels_(channels), bins_(bins), sums_(channels * (channels + 1) / 2 * bins) {}

    void add(const std::vector<Complex>& transforms) {
        Complex* sum = sums_.data();
        for (std::size_t i = 0; i < channels_; ++i)
            for (std::size_t j = 0; j <= i; ++j, sum += bins_) {
                const Complex* a = transforms.data() + i * bins_;
                const Complex* b = transforms.data() + j * bins_;
                for (std::size_t k = 0; k < bins_; ++k) sum[k] += a[k] * std::conj(b[k]);
            }
    }

    std::vector<Complex> matrices(double scale) const {
        std::vector<Complex> result(bins_ * channels_ * channels_);
        const Complex* sum = sums_.data();
        for (std::size_t i = 0; i < channels_; ++i)
            for (std::size_t j = 0; j <= i; ++j, sum += bins_)
                for (std::size_t k = 0; k < bins_; ++k) {
                    // One-sided: everything but the constant term and the one at half the sampling rate counts twice.
                    Complex value = (k == 0 || k + 1 == bins_ ? 0.5 : 1.0) * scale * sum[k];
                    if (i == j)
                        value = value.real();  // contracted products leave a rounding error in the imaginary part
                    result[(k * channels_ + j) * channels_ + i] = value;
                    result[(k * channels_ + i) * channels_ + j] = std::conj(value);
                }
        return result;
    }

  private:
    std::size_t channels_, bins_;
    std::vector<Complex> sums_;
};

/// For every sample whether it or one before it is missing, as a running count: a segment is complete when the count
/// does not grow.
std::vector<std::uint32_t> missing_before(const TimeSeries& series) {
    std::vector<std::uint32_t> count(series.size() + 1, 0);
    for (std::size_t n = 0; n < series.size(); ++n) {
        bool missing = false;
        for (const Channel& channel : series.channels) missing = missing || !std::isfinite(channel.samples[n]);
        count[n + 1] = count[n] + (missing ? 1U : 0U);
    }
    return count;
}

void set_averages(CrossSpectra& spectra) {
    spectra.averages = independent_averages(spectra.segments);
    spectra.averages_per_bin = averages_per_bin(spectra.segments);
}

/// No window is complete: which channel is to blame.
[[noreturn]] void refuse_gaps(const TimeSeries& series) {
    const Channel* worst = nullptr;
    std::ptrdiff_t most = -1;
    for (const Channel& channel : series.channels) {
        const std::ptrdiff_t missing =
            std::count_if(channel.samples.begin(), channel.samples.end(), [](double x) { return !std::isfinite(x); });
        if (missing > most) most = missing, worst = &channel;
    }
    const bool dead = worst && most == static_cast<std::ptrdiff_t>(worst->samples.size());
    throw parameters::ParameterError(
        "window_s",
        dead ? fmt::format("{} holds no sample at all, so that no window of the record is complete",
                           worst->description.name)
             : fmt::format("every window of the record holds a missing sample; {} misses most, {}",
                           worst ? worst->description.name : "nothing", most),
        dead ? "the description without this channel"
             : "a shorter window, a record with fewer gaps, or the description without this channel");
}

}  // namespace

std::vector<double> without_trend(const std::vector<double>& samples) {
    double n = 0.0, sum_x = 0.0, sum_y = 0.0;
    for (std::size_t i = 0; i < samples.size(); ++i)
        if (std::isfinite(samples[i])) {
            n += 1.0;
            sum_x += static_cast<double>(i);
            sum_y += samples[i];
        }
    if (n < 2.0) return samples;
    const double mean_x = sum_x / n, mean_y = sum_y / n;
    double xx = 0.0, xy = 0.0;
    for (std::size_t i = 0; i < samples.size(); ++i)
        if (std::isfinite(samples[i])) {
            const double x = static_cast<double>(i) - mean_x;
            xx += x * x;
            xy += x * (samples[i] - mean_y);
        }
    const double slope = xy / xx;
    std::vector<double> result(samples);
    for (std::size_t i = 0; i < samples.size(); ++i) result[i] -= mean_y + slope * (static_cast<double>(i) - mean_x);
    return result;
}

Segmentation segmentation_of(const SegmentOptions& options, double sampling_rate_hz, std::size_t samples) {
    assert(options.overlap >= 0.0 && options.overlap <= 0.9 && options.window_s > 0.0);
    Segmentation segments{
        options.window, fast_length(static_cast<std::size_t>(std::lround(options.window_s * sampling_rate_hz))), 0, 0};
    segments.hop = std::max<std::size_t>(
        1, static_cast<std::size_t>(std::lround((1.0 - options.overlap) * static_cast<double>(segments.length))));
    if (samples >= segments.length) segments.count = 1 + (samples - segments.length) / segments.hop;
    return segments;
}

double CrossSpectra::coherence(std::size_t bin, std::size_t i, std::size_t j) const {
    const double power = psd(bin, i) * psd(bin, j);
    return power > 0.0 ? std::norm(at(bin, i, j)) / power : 0.0;
}

CrossSpectra estimate_cross_spectra(const TimeSeries& series, const SegmentOptions& options) {
    const double rate = series.sampling_rate_hz;
    const auto first = static_cast<std::size_t>(std::max(0.0, std::ceil(options.from_s * rate)));
    const std::size_t last = options.to_s * rate < static_cast<double>(series.size())
                                 ? static_cast<std::size_t>(options.to_s * rate)
                                 : series.size();
    const std::size_t samples = last > first ? last - first : 0;
    CrossSpectra spectra;
    spectra.sampling_rate_hz = rate;
    spectra.segments = segmentation_of(options, rate, samples);
    if (spectra.segments.count == 0)
        throw parameters::ParameterError("window_s",
                                         fmt::format("the record of {:g} s is shorter than one window of {:g} s",
                                                     static_cast<double>(samples) / rate, options.window_s),
                                         "a shorter window or a longer record");
    const std::size_t length = spectra.segments.length;
    const FourierTransform transform(length);
    const std::vector<double> window = window_samples(options.window, length);
    const std::vector<std::uint32_t> missing = missing_before(series);

    std::vector<std::vector<double>> own;
    std::vector<const double*> samples_of;
    for (const Channel& channel : series.channels) {
        spectra.channels.push_back(channel.description);
        if (options.remove_trend) own.push_back(without_trend(channel.samples));
        samples_of.push_back(options.remove_trend ? own.back().data() : channel.samples.data());
    }
    const std::size_t bins = transform.bins();
    PairSums sums(spectra.size(), bins);
    std::vector<double> segment(length);
    std::vector<Complex> transforms(spectra.size() * bins);
    std::size_t used = 0;
    for (std::size_t k = 0; k < spectra.segments.count; ++k) {
        const std::size_t begin = first + k * spectra.segments.hop;
        if (missing[begin + length] != missing[begin]) continue;
        for (std::size_t i = 0; i < samples_of.size(); ++i) {
            for (std::size_t n = 0; n < length; ++n) segment[n] = window[n] * samples_of[i][begin + n];
            transform.forward(segment.data(), transforms.data() + i * bins);
        }
        sums.add(transforms);
        ++used;
    }
    spectra.segments_skipped = spectra.segments.count - used;
    spectra.segments.count = used;
    if (used == 0) refuse_gaps(series);
    const double energy = std::inner_product(window.begin(), window.end(), window.begin(), 0.0);
    spectra.matrices = sums.matrices(2.0 / (rate * energy * static_cast<double>(used)));
    for (std::size_t k = 0; k < bins; ++k)
        spectra.frequency_hz.push_back(static_cast<double>(k) * rate / static_cast<double>(length));
    set_averages(spectra);
    return spectra;
}

CrossSpectra merged(const std::vector<CrossSpectra>& parts) {
    assert(!parts.empty());
    CrossSpectra result = parts.front();
    std::size_t count = 0;
    for (const CrossSpectra& part : parts) count += part.segments.count;
    for (Complex& value : result.matrices)
        value *= static_cast<double>(parts.front().segments.count) / static_cast<double>(count);
    for (std::size_t p = 1; p < parts.size(); ++p) {
        assert(parts[p].matrices.size() == result.matrices.size() &&
               parts[p].sampling_rate_hz == result.sampling_rate_hz);
        const double share = static_cast<double>(parts[p].segments.count) / static_cast<double>(count);
        for (std::size_t i = 0; i < result.matrices.size(); ++i) result.matrices[i] += share * parts[p].matrices[i];
        result.segments_skipped += parts[p].segments_skipped;
    }
    result.segments.count = count;
    set_averages(result);
    return result;
}

CrossSpectra to_acceleration(const CrossSpectra& spectra) {
    CrossSpectra result = spectra;
    const std::size_t n = spectra.size();
    for (std::size_t k = 0; k < spectra.bins(); ++k) {
        const Complex derivative(0.0, 2.0 * std::numbers::pi * spectra.frequency_hz[k]);
        for (std::size_t j = 0; j < n; ++j)
            for (std::size_t i = 0; i < n; ++i)
                result.matrices[(k * n + j) * n + i] *=
                    std::pow(derivative, derivatives_to_acceleration(spectra.channels[i].quantity)) *
                    std::conj(std::pow(derivative, derivatives_to_acceleration(spectra.channels[j].quantity)));
    }
    for (ChannelDescription& channel : result.channels) {
        channel.quantity = ChannelQuantity::acceleration;
        channel.unit.clear();
    }
    return result;
}

}  // namespace railpem::recordings
