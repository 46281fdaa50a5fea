#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "parameters/parameter_error.hpp"
#include "recordings/checks/checks.hpp"
#include "recordings/estimates/confidence.hpp"

namespace railpem::recordings::checks {
namespace {

constexpr std::size_t blocks = 8;
constexpr double window_s = 1.0;

Fault whole_record(FaultKind kind, Severity severity, std::string says, double value, std::string unit, double p) {
    Fault found;
    found.kind = kind;
    found.severity = severity;
    found.says = std::move(says);
    found.value = value;
    found.unit = std::move(unit);
    found.false_alarm = p;
    return found;
}

/// Band powers of the blocks of a record, and the averages behind each.
struct BandPowers {
    double low_hz = 0.0, high_hz = 0.0;
    std::vector<double> power, averages;
};

BandPowers band_powers(const std::vector<CrossSpectra>& parts, std::size_t channel, double low, double high) {
    BandPowers band{low, high, {}, {}};
    for (const CrossSpectra& part : parts) {
        std::vector<double> weights;
        double sum = 0.0;
        for (std::size_t k = 1; k + 1 < part.bins(); ++k)
            if (part.frequency_hz[k] >= low && part.frequency_hz[k] < high) {
                weights.push_back(part.psd(k, channel));
                sum += weights.back();
            }
        band.power.push_back(sum);
        band.averages.push_back(sum > 0.0 ? band_averages(part.segments, weights) : 0.0);
    }
    return band;
}

/// Bartlett's test that the powers are of one process: χ² with one degree of freedom less than blocks.
double bartlett_exceeded(const BandPowers& band) {
    double degrees = 0.0, weighted = 0.0, logs = 0.0, inverse = 0.0;
    for (std::size_t b = 0; b < band.power.size(); ++b) {
        if (band.power[b] <= 0.0) return 1.0;
        // The estimated weights make the averages look a little more than they are: nine tenths of them are counted.
        const double nu = 2.0 * 0.9 * band.averages[b];
        degrees += nu;
        weighted += nu * band.power[b];
        logs += nu * std::log(band.power[b]);
        inverse += 1.0 / nu;
    }
    const double k = static_cast<double>(band.power.size());
    const double statistic =
        (degrees * std::log(weighted / degrees) - logs) / (1.0 + (inverse - 1.0 / degrees) / (3.0 * (k - 1.0)));
    return chi_squared_exceeded(statistic, k - 1.0);
}

void check_levels(const Evidence& evidence, std::vector<Fault>& faults) {
    const double duration = evidence.series().duration_s();
    if (duration < 4.0 * window_s * 2.0) return;
    const std::size_t count = std::min<std::size_t>(blocks, static_cast<std::size_t>(duration / (2.0 * window_s)));
    TimeSeries whole;
    whole.sampling_rate_hz = evidence.series().sampling_rate_hz;
    for (const Channel& channel : evidence.series().channels)
        whole.channels.push_back({channel.description, without_trend(channel.samples), {}});
    std::vector<CrossSpectra> parts;
    for (std::size_t b = 0; b < count; ++b) {
        const double from = duration * static_cast<double>(b) / static_cast<double>(count);
        try {
            parts.push_back(estimate_cross_spectra(whole, {.window_s = window_s,
                                                           .remove_trend = false,
                                                           .from_s = from,
                                                           .to_s = from + duration / static_cast<double>(count)}));
        } catch (const parameters::ParameterError&) {  // a part without one complete window says nothing
        }
    }
    if (parts.size() < 3) return;
    for (std::size_t i = 0; i < evidence.series().channels.size(); ++i) {
        double least = 1.0, spread = 0.0, low = 0.0, high = 0.0;
        int bands = 0, changing = 0;
        for (double from = 3.0; 2.0 * from < 0.4 * evidence.series().sampling_rate_hz; from *= 2.0) {
            const BandPowers band = band_powers(parts, i, from, 2.0 * from);
            const double p = bartlett_exceeded(band);
            const auto [smallest, largest] = std::minmax_element(band.power.begin(), band.power.end());
            ++bands;
            if (p > 1e-7) continue;
            ++changing;
            least = std::min(least, p);
            const double change = 10.0 * std::log10(*largest / *smallest);
            if (change > spread) {
                spread = change;
                low = from;
                high = 2.0 * from;
            }
        }
        if (changing == 0 || spread < 3.0) continue;
        Fault found = whole_record(FaultKind::not_stationary, spread > 10.0 ? Severity::warning : Severity::note,
                                   fmt::format("the level changes along the record by up to {:.1f} dB ({:g}–{:g} Hz; "
                                               "{} of {} octaves): intervals of its spectra are too narrow",
                                               spread, low, high, changing, bands),
                                   spread, "dB", least);
        found.channels = {evidence.name(i)};
        found.low_hz = low;
        found.high_hz = high;
        faults.push_back(std::move(found));
    }
}

/// Parts of the record in which the axle boxes (or all channels, where there are none) are quiet.
void check_stops(const Evidence& evidence, std::vector<Fault>& faults) {
    const TimeSeries& series = evidence.series();
    std::vector<std::size_t> members;
    for (const Location wanted : {Location::wheel, Location::bogie, Location::none, Location::body})
        if (members.empty())
            for (std::size_t i = 0; i < series.channels.size(); ++i)
                if (series.channels[i].description.location == wanted) members.push_back(i);
    const auto step = static_cast<std::size_t>(0.5 * series.sampling_rate_hz);
    if (step < 8 || members.empty()) return;
    std::vector<double> level, whole;
    for (const std::size_t i : members) {
        double all = 1e-300;
        for (const double x : evidence.detrended[i]) all += x * x;
        whole.push_back(all);
    }
    for (std::size_t begin = 0; begin + step <= series.size(); begin += step) {
        double sum = 0.0;
        for (std::size_t m = 0; m < members.size(); ++m) {
            const std::vector<double>& x = evidence.detrended[members[m]];
            for (std::size_t n = begin; n < begin + step; ++n) sum += x[n] * x[n] / whole[m];
        }
        level.push_back(std::sqrt(sum));
    }
    if (level.size() < 8) return;
    std::vector<double> sorted = level;
    std::sort(sorted.begin(), sorted.end());
    // A twentieth of the usual level, for two seconds at least. The upper quartile is taken for usual: a record may
    // stand for half its time.
    const double quiet = 0.05 * sorted[3 * sorted.size() / 4];
    for (std::size_t k = 0; k < level.size();) {
        const std::size_t begin = k;
        while (k < level.size() && level[k] < quiet) ++k;
        if (k - begin >= 4) {
            const double from = static_cast<double>(begin * step) / series.sampling_rate_hz,
                         to = static_cast<double>(k * step) / series.sampling_rate_hz;
            Fault found = whole_record(
                FaultKind::stop, Severity::error,
                fmt::format("from {:.1f} to {:.1f} s nothing moves: a stop, or an interruption of all channels", from,
                            to),
                to - from, "s", 0.0);
            found.from_s = from;
            found.to_s = to;
            faults.push_back(std::move(found));
        }
        k = std::max(k, begin + 1);
    }
}

void check_speed_channel(const Evidence& evidence, std::vector<Fault>& faults) {
    std::vector<double> speed;
    for (const double v : evidence.series().speed_m_per_s)
        if (std::isfinite(v)) speed.push_back(v);
    if (speed.size() < 100) return;
    std::sort(speed.begin(), speed.end());
    const double low = speed[speed.size() / 100], high = speed[speed.size() - 1 - speed.size() / 100],
                 middle = speed[speed.size() / 2];
    if (middle <= 0.0 || (high - low) / middle < 0.01) return;
    faults.push_back(whole_record(
        FaultKind::speed_changes, (high - low) / middle > 0.05 ? Severity::error : Severity::warning,
        fmt::format(
            "the speed channel runs from {:.4g} to {:.4g} m/s ({:.1f} %): lines are smeared and spectra mix speeds",
            low, high, 100.0 * (high - low) / middle),
        (high - low) / middle, "1", 0.0));
}

/// The delay of the longest pair, part by part.
void check_speed_by_delays(const Evidence& evidence, std::vector<Fault>& faults) {
    const PairDelay* longest = nullptr;
    for (const PairDelay& pair : evidence.delays)
        if (pair.delay.seconds > 0.0 && (!longest || pair.distance_m > longest->distance_m)) longest = &pair;
    const TimeSeries& series = evidence.series();
    if (!longest || series.duration_s() < 12.0 * longest->delay.seconds) return;
    const std::size_t count = std::min<std::size_t>(
        6, static_cast<std::size_t>(series.duration_s() / std::max(5.0, 6.0 * longest->delay.seconds)));
    std::vector<double> speeds, errors;
    for (std::size_t b = 0; b < count && count >= 2; ++b) {
        const auto cut = [&](std::size_t channel) {
            const auto& x = evidence.slow(channel);
            return std::vector<double>(x.begin() + static_cast<std::ptrdiff_t>(b * x.size() / count),
                                       x.begin() + static_cast<std::ptrdiff_t>((b + 1) * x.size() / count));
        };
        const double usual = longest->delay.seconds;
        const Delay delay = estimate_delay(cut(longest->front), cut(longest->rear), evidence.slow_rate_hz(),
                                           {.least_s = 0.7 * usual, .most_s = 1.4 * usual, .window_s = 1.0});
        if (!delay.found) continue;
        speeds.push_back(longest->distance_m / delay.seconds);
        // Two hundredths of a percent for what the errors of short parts leave out.
        errors.push_back(speeds.back() * std::hypot(2e-4, delay.standard_error_s / delay.seconds));
    }
    if (speeds.size() < 2) return;
    double weights = 0.0, mean = 0.0, chi = 0.0;
    for (std::size_t i = 0; i < speeds.size(); ++i) {
        weights += std::pow(errors[i], -2);
        mean += speeds[i] * std::pow(errors[i], -2);
    }
    mean /= weights;
    for (std::size_t i = 0; i < speeds.size(); ++i) chi += std::pow((speeds[i] - mean) / errors[i], 2);
    const double p = chi_squared_exceeded(chi, static_cast<double>(speeds.size()) - 1.0);
    const auto [slowest, fastest] = std::minmax_element(speeds.begin(), speeds.end());
    const double range = (*fastest - *slowest) / mean;
    if (p > 1e-8 || range < 0.004) return;
    faults.push_back(whole_record(
        FaultKind::speed_changes, range > 0.05 ? Severity::error : Severity::warning,
        fmt::format("by the delay from {} to {} the speed runs from {:.4g} to {:.4g} m/s ({:.1f} %): lines are smeared "
                    "and spectra mix speeds",
                    evidence.name(longest->front), evidence.name(longest->rear), *slowest, *fastest, 100.0 * range),
        range, "1", p));
}

void check_stated_speed(const Evidence& evidence, std::vector<Fault>& faults) {
    const RecordingDescription& d = evidence.recording.description;
    if (!evidence.speed || d.speed_m_per_s <= 0.0) return;
    const double error = std::hypot(evidence.speed->standard_error_m_per_s,
                                    std::max(d.speed_standard_error_m_per_s, 5e-4 * d.speed_m_per_s));
    const double difference = evidence.speed->speed_m_per_s - d.speed_m_per_s, z = std::abs(difference) / error;
    // The geometry of the believed vehicle enters as well: less than half a percent is not held against the stated
    // speed.
    if (z < 5.0 || std::abs(difference) < 0.005 * d.speed_m_per_s) return;
    faults.push_back(whole_record(
        FaultKind::speed_mismatch, Severity::error,
        fmt::format("stated are {:.4g} m/s, the delays between the channels say {:.4g} ± {:.2g} m/s", d.speed_m_per_s,
                    evidence.speed->speed_m_per_s, 1.645 * evidence.speed->standard_error_m_per_s),
        difference, "m/s", 2.0 * normal_exceeded(z)));
}

}  // namespace

void check_stationarity(const Evidence& evidence, std::vector<Fault>& faults) {
    const double duration = evidence.series().duration_s();
    // 20 s: 20 windows of 2 s, the least for cross-spectra of 9 channels (averages must exceed channels twice).
    if (duration < 20.0)
        faults.push_back(
            whole_record(FaultKind::too_short, duration < 4.0 ? Severity::error : Severity::warning,
                         fmt::format("{:.3g} s are short: with 2 s windows there are {:.0f} independent averages",
                                     duration, std::max(0.0, std::floor(duration - 1.0))),
                         duration, "s", 0.0));
    check_levels(evidence, faults);
    check_stops(evidence, faults);
    check_speed_channel(evidence, faults);
    if (evidence.series().speed_m_per_s.empty()) check_speed_by_delays(evidence, faults);
    check_stated_speed(evidence, faults);
}

}  // namespace railpem::recordings::checks
