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
}

}  // namespace railpem::recordings::checks
