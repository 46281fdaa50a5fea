#include <fmt/format.h>

#include <algorithm>
#include <boost/sort/spreadsort/float_sort.hpp>
#include <cmath>

#include "recordings/checks/checks.hpp"
#include "recordings/checks/median.hpp"
#include "recordings/estimates/confidence.hpp"
#include "recordings/units.hpp"

namespace railpem::recordings::checks {
namespace {

/// Values closer than this share of the range are the same number written twice.
constexpr double same_value = 1e-9;

struct Run {
    std::size_t begin = 0, length = 0;
};

Fault fault(const Evidence& evidence, std::size_t channel, FaultKind kind, Severity severity, std::string says) {
    Fault found;
    found.kind = kind;
    found.severity = severity;
    found.channels = {evidence.name(channel)};
    found.says = std::move(says);
    return found;
}

void check_missing(const Evidence& evidence, std::size_t channel, std::vector<Fault>& faults) {
    const auto& x = evidence.series().channels[channel].samples;
    const double rate = evidence.series().sampling_rate_hz;
    std::size_t missing = 0, gaps = 0;
    Run longest, first;
    for (std::size_t n = 0; n < x.size();) {
        if (std::isfinite(x[n])) {
            ++n;
            continue;
        }
        const std::size_t begin = n;
        while (n < x.size() && !std::isfinite(x[n])) ++n;
        missing += n - begin;
        if (gaps++ == 0) first = {begin, n - begin};
        if (n - begin > longest.length) longest = {begin, n - begin};
    }
    if (missing == 0) return;
    const double share = static_cast<double>(missing) / static_cast<double>(x.size());
    Fault found =
        fault(evidence, channel, FaultKind::missing_samples, share > 0.01 ? Severity::error : Severity::warning,
              fmt::format("{} of {} samples are missing in {} gap{}, the longest of {:.3g} s at {:.3f} s", missing,
                          x.size(), gaps, gaps > 1 ? "s" : "", static_cast<double>(longest.length) / rate,
                          static_cast<double>(longest.begin) / rate));
    found.from_s = static_cast<double>(longest.begin) / rate;
    found.to_s = static_cast<double>(longest.begin + longest.length) / rate;
    found.value = share;
    found.unit = "1";
    faults.push_back(std::move(found));
}

/// Distinct levels of the sorted values from one end: how many samples sit on the first one and on the next five on
/// average.
struct EndLevels {
    std::size_t on_first = 0;
    double on_next = 0.0;
};

EndLevels end_levels(const std::vector<double>& sorted, bool top) {
    const double tolerance = same_value * (sorted.back() - sorted.front());
    EndLevels levels;
    std::size_t at = 0, distinct = 0, others = 0;
    const auto value = [&](std::size_t i) { return top ? sorted[sorted.size() - 1 - i] : sorted[i]; };
    double level = value(0);
    for (; at < sorted.size(); ++at) {
        if (std::abs(value(at) - level) > tolerance) {
            if (++distinct > 5) break;
            level = value(at);
        }
        (distinct == 0 ? levels.on_first : others) += 1;
    }
    levels.on_next =
        distinct > 0 ? static_cast<double>(others) / static_cast<double>(std::min<std::size_t>(distinct, 5)) : 0.0;
    return levels;
}

void check_clipping(const Evidence& evidence, std::size_t channel, const std::vector<double>& sorted,
                    std::vector<Fault>& faults) {
    std::size_t clipped = 0;
    double worst = 1.0;
    for (const bool top : {true, false}) {
        // The tail of a sound channel thins out towards its end: no more samples on the last level than on those before
        // it.
        const EndLevels levels = end_levels(sorted, top);
        const double p = poisson_at_least(static_cast<double>(levels.on_first), std::max(1.0, levels.on_next));
        if (p > false_alarm) continue;
        clipped += levels.on_first;
        worst = std::min(worst, p);
    }
    if (clipped == 0) return;
    const double share = static_cast<double>(clipped) / static_cast<double>(sorted.size());
    const std::string unit = value_unit(evidence.series().channels[channel].description);
    Fault found = fault(evidence, channel, FaultKind::clipping, Severity::error,
                        fmt::format("clipped: {} samples ({:.3g} %) stand on the end of the range, {:.4g} to {:.4g} {}",
                                    clipped, 100.0 * share, sorted.front(), sorted.back(), unit));
    found.value = share;
    found.unit = "1";
    found.false_alarm = worst;
    faults.push_back(std::move(found));
}

/// Runs of one and the same value, longer than chance gives at the channel's resolution.
void check_held(const Evidence& evidence, std::size_t channel, const std::vector<double>& sorted,
                std::vector<Fault>& faults) {
    constexpr std::size_t shortest = 8;
    const auto& x = evidence.series().channels[channel].samples;
    const double tolerance = same_value * (sorted.back() - sorted.front());
    std::vector<Run> runs;
    std::size_t repeats = 0, pairs = 0;
    for (std::size_t n = 0; n < x.size();) {
        const std::size_t begin = n++;
        while (n < x.size() && std::abs(x[n] - x[begin]) <= tolerance) ++n;
        const bool at_end = x[begin] >= sorted.back() - tolerance || x[begin] <= sorted.front() + tolerance;
        if (n - begin >= shortest && !at_end) runs.push_back({begin, n - begin});
        if (n - begin < shortest) repeats += n - begin - 1;
        pairs += n - begin < shortest ? n - begin : 1;
    }
    // Chance that a sample repeats the one before, and with it the expected number of runs of a length. Slow channels
    // of coarse resolution stand still at their turning points: a run must also be many times the usual one.
    const double repeat = (static_cast<double>(repeats) + 1.0) / (static_cast<double>(pairs) + 2.0);
    const double usual = 1.0 / (1.0 - repeat);
    double held = 0.0;
    Run longest;
    double worst = 1.0;
    std::size_t count = 0;
    for (const Run& run : runs) {
        const double expected = static_cast<double>(x.size()) * std::pow(repeat, static_cast<double>(run.length) - 1.0);
        if (expected > false_alarm || static_cast<double>(run.length) < 20.0 * usual - 12.0) continue;
        held += static_cast<double>(run.length);
        ++count;
        worst = std::min(worst, expected);
        if (run.length > longest.length) longest = run;
    }
    if (count == 0) return;
    const double rate = evidence.series().sampling_rate_hz;
    Fault found = fault(
        evidence, channel, FaultKind::held_values,
        held / static_cast<double>(x.size()) > 0.01 ? Severity::error : Severity::warning,
        fmt::format("the value stands still {} time{}, {:.3g} s in all, the longest {:.3g} s at {:.3f} s: a dropout",
                    count, count > 1 ? "s" : "", held / rate, static_cast<double>(longest.length) / rate,
                    static_cast<double>(longest.begin) / rate));
    found.from_s = static_cast<double>(longest.begin) / rate;
    found.to_s = static_cast<double>(longest.begin + longest.length) / rate;
    found.value = held / static_cast<double>(x.size());
    found.unit = "1";
    found.false_alarm = worst;
    faults.push_back(std::move(found));
}

/// The values that a channel takes: how many, and how far apart.
struct Steps {
    std::size_t levels = 1;
    double step = 0.0;  ///< median distance of neighbouring values
    double rms = 0.0;
};

Steps steps_of(const std::vector<double>& sorted) {
    const double tolerance = same_value * (sorted.back() - sorted.front());
    Steps steps;
    std::vector<double> distances;
    double mean = sorted.front() / static_cast<double>(sorted.size()), square = 0.0;
    for (std::size_t i = 1; i < sorted.size(); ++i) {
        if (sorted[i] - sorted[i - 1] > tolerance) distances.push_back(sorted[i] - sorted[i - 1]);
        mean += sorted[i] / static_cast<double>(sorted.size());
    }
    for (const double value : sorted) square += (value - mean) * (value - mean);
    steps.rms = std::sqrt(square / static_cast<double>(sorted.size()));
    steps.levels = distances.size() + 1;
    if (!distances.empty()) steps.step = median(distances);
    return steps;
}

/// Few digits; true where they are so few that values stand still of themselves.
bool check_resolution(const Evidence& evidence, std::size_t channel, const std::vector<double>& sorted,
                      std::vector<Fault>& faults) {
    const Steps steps = steps_of(sorted);
    // Rounding adds noise of step/√12: at a tenth of the rms it is −31 dB, seen in every quiet band.
    if (steps.levels < 2 || sorted.size() < 10 * steps.levels || steps.step < 0.1 * steps.rms) return false;
    const double noise = steps.step / std::sqrt(12.0);
    const bool spoils = noise > 0.1 * steps.rms;  // −20 dB: seen in the level of the channel itself
    const std::string unit = value_unit(evidence.series().channels[channel].description);
    Fault found = fault(
        evidence, channel, FaultKind::coarse_resolution, spoils ? Severity::warning : Severity::note,
        fmt::format("few digits: {} different values in steps of {:.3g} {}, {:.2g} of the rms; the rounding is noise "
                    "of {:.3g} {} rms",
                    steps.levels, steps.step, unit, steps.step / steps.rms, noise, unit));
    found.value = steps.step;
    found.unit = unit;
    faults.push_back(std::move(found));
    return spoils;
}

}  // namespace

void check_samples(const Evidence& evidence, std::vector<Fault>& faults) {
    for (std::size_t i = 0; i < evidence.series().channels.size(); ++i) {
        check_missing(evidence, i, faults);
        std::vector<double> sorted;
        std::copy_if(evidence.series().channels[i].samples.begin(), evidence.series().channels[i].samples.end(),
                     std::back_inserter(sorted), [](double x) { return std::isfinite(x); });
        if (sorted.empty()) {
            faults.push_back(
                fault(evidence, i, FaultKind::constant, Severity::error, "the channel holds no number at all"));
            continue;
        }
        boost::sort::spreadsort::float_sort(sorted.begin(), sorted.end());
        const double range = sorted.back() - sorted.front();
        if (range <= 1e-12 * std::max(std::abs(sorted.back()), std::abs(sorted.front())) || range == 0.0) {
            Fault found = fault(evidence, i, FaultKind::constant, Severity::error,
                                fmt::format("the channel is constant: {:.4g} throughout", sorted.front()));
            found.value = sorted.front();
            found.unit = value_unit(evidence.series().channels[i].description);
            faults.push_back(std::move(found));
            continue;
        }
        check_clipping(evidence, i, sorted, faults);
        if (!check_resolution(evidence, i, sorted, faults)) check_held(evidence, i, sorted, faults);
    }
}

}  // namespace railpem::recordings::checks
