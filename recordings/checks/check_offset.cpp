#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "recordings/checks/checks.hpp"
#include "recordings/estimates/confidence.hpp"
#include "recordings/estimates/fourier_transform.hpp"
#include "recordings/units.hpp"

namespace railpem::recordings::checks {
namespace {

constexpr std::size_t parts = 16;
constexpr double offset_false_alarm = 1e-5;  ///< per channel and test

struct Line {
    double mean = 0.0, slope = 0.0;  ///< slope per part
    double mean_error = 0.0, slope_error = 0.0;
    double p_mean = 1.0, p_slope = 1.0;
};

/// Means of the parts of the record (finite samples only) and a line through them.
bool fit_line(const std::vector<double>& samples, Line& line) {
    std::vector<double> means;
    for (std::size_t p = 0; p < parts; ++p) {
        double sum = 0.0, count = 0.0;
        for (std::size_t n = p * samples.size() / parts; n < (p + 1) * samples.size() / parts; ++n)
            if (std::isfinite(samples[n])) {
                sum += samples[n];
                count += 1.0;
            }
        if (count == 0.0) return false;
        means.push_back(sum / count);
    }
    const double n = parts, centre = 0.5 * (n - 1.0);
    double xx = 0.0, xy = 0.0;
    for (std::size_t p = 0; p < parts; ++p) line.mean += means[p] / n;
    for (std::size_t p = 0; p < parts; ++p) {
        const double x = static_cast<double>(p) - centre;
        xx += x * x;
        xy += x * (means[p] - line.mean);
    }
    line.slope = xy / xx;
    double residual = 0.0;
    for (std::size_t p = 0; p < parts; ++p)
        residual += std::pow(means[p] - line.mean - line.slope * (static_cast<double>(p) - centre), 2);
    const double variance = residual / (n - 2.0);
    line.mean_error = std::sqrt(variance / n);
    line.slope_error = std::sqrt(variance / xx);
    line.p_mean = line.mean_error > 0.0 ? 2.0 * student_exceeded(std::abs(line.mean) / line.mean_error, n - 2.0) : 0.0;
    line.p_slope =
        line.slope_error > 0.0 ? 2.0 * student_exceeded(std::abs(line.slope) / line.slope_error, n - 2.0) : 0.0;
    return true;
}

double rms_of(const std::vector<double>& samples) {
    double sum = 0.0;
    for (const double x : samples) sum += x * x;
    return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(1, samples.size())));
}

/// Slope α of a spectrum like f^(−α) at low frequency: regression of the log-periodogram on log f, whose errors have
/// the variance π²/6. The record is tapered, so that a trend or the power above does not leak in; only every second bin
/// counts then.
void check_low_frequency(const Evidence& evidence, std::size_t channel, double rms, std::vector<Fault>& faults) {
    constexpr double highest_hz = 0.8, least_slope = 0.5;
    const auto& samples = evidence.detrended[channel];
    const double rate = evidence.series().sampling_rate_hz;
    const std::size_t length = samples.size() - samples.size() % 2;
    // Averaged down first: only the lowest bins are wanted.
    const std::size_t block = std::max<std::size_t>(1, static_cast<std::size_t>(rate / 20.0));
    std::vector<double> slow;
    for (std::size_t n = 0; n + block <= length; n += block) {
        double sum = 0.0;
        for (std::size_t k = 0; k < block; ++k) sum += samples[n + k];
        slow.push_back(sum / static_cast<double>(block));
    }
    if (slow.size() < 64) return;
    const std::vector<double> window = window_samples(Window::hann, slow.size());
    slow = without_trend(slow);
    for (std::size_t n = 0; n < slow.size(); ++n) slow[n] *= window[n];
    const FourierTransform transform(fast_length(slow.size()));
    const double bin_hz = rate / static_cast<double>(block) / static_cast<double>(slow.size());
    slow.resize(transform.length(), 0.0);
    std::vector<std::complex<double>> spectrum(transform.bins());
    transform.forward(slow.data(), spectrum.data());
    std::vector<double> x, y;
    for (double f = 3.0 * bin_hz; f <= highest_hz; f += 2.0 * bin_hz) {
        const auto k = static_cast<std::size_t>(
            std::lround(f / (rate / static_cast<double>(block)) * static_cast<double>(transform.length())));
        if (k >= spectrum.size() || std::norm(spectrum[k]) <= 0.0) return;
        x.push_back(std::log(f));
        y.push_back(std::log(std::norm(spectrum[k])));
    }
    if (x.size() < 8) return;
    const double n = static_cast<double>(x.size());
    double mean_x = 0.0, mean_y = 0.0, xx = 0.0, xy = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        mean_x += x[i] / n;
        mean_y += y[i] / n;
    }
    for (std::size_t i = 0; i < x.size(); ++i) {
        xx += (x[i] - mean_x) * (x[i] - mean_x);
        xy += (x[i] - mean_x) * (y[i] - mean_y);
    }
    const double slope = -xy / xx, error = std::numbers::pi / std::sqrt(6.0 * xx);
    // The log-periodogram is skewed (left tail), so a normal threshold is not exact: 3.7 deviations leave 1e-4.
    if (slope < least_slope || slope < 3.7 * error) return;
    Fault found;
    found.kind = FaultKind::low_frequency_noise;
    found.channels = {evidence.name(channel)};
    found.says = fmt::format(
        "below {:g} Hz the spectrum rises towards zero like f^-{:.2g} (± {:.2g}): noise or drift of the sensor, not "
        "vibration",
        highest_hz, slope, 1.645 * error);
    found.high_hz = highest_hz;
    found.value = slope;
    found.unit = "1";
    found.false_alarm = normal_exceeded(slope / error);
    if (rms > 0.0) faults.push_back(std::move(found));
}

}  // namespace

void check_offset(const Evidence& evidence, std::vector<Fault>& faults) {
    // Below these shares of the rms an offset or a drift is of no consequence for anything that is computed here.
    constexpr double least_offset = 0.02, least_drift = 0.05;
    for (std::size_t i = 0; i < evidence.series().channels.size(); ++i) {
        const Channel& channel = evidence.series().channels[i];
        const double rms = rms_of(evidence.detrended[i]);
        Line line;
        if (rms == 0.0 || channel.samples.size() < 16 * parts || !fit_line(channel.samples, line)) continue;
        const std::string unit = value_unit(channel.description);
        if (line.p_mean < offset_false_alarm && std::abs(line.mean) > least_offset * rms) {
            Fault found;
            found.kind = FaultKind::offset;
            found.channels = {channel.description.name};
            found.says = fmt::format(
                "offset of {:.4g} {} (± {:.2g}), {:.2g} of the rms; it is left in the samples and taken out of every "
                "spectrum",
                line.mean, unit, 1.645 * line.mean_error, std::abs(line.mean) / rms);
            found.value = line.mean;
            found.unit = unit;
            found.false_alarm = line.p_mean;
            faults.push_back(std::move(found));
        }
        const double drift = line.slope * static_cast<double>(parts);
        if (line.p_slope < offset_false_alarm && std::abs(drift) > least_drift * rms) {
            Fault found;
            found.kind = FaultKind::drift;
            found.channels = {channel.description.name};
            found.says = fmt::format("drift of {:.4g} {} over the record, {:.2g} of the rms", drift, unit,
                                     std::abs(drift) / rms);
            found.value = drift;
            found.unit = unit;
            found.false_alarm = line.p_slope;
            faults.push_back(std::move(found));
        }
        check_low_frequency(evidence, i, rms, faults);
    }
}

}  // namespace railpem::recordings::checks
