#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "recordings/checks/checks.hpp"
#include "recordings/estimates/confidence.hpp"
#include "recordings/stated_speed.hpp"

namespace railpem::recordings::checks {
namespace {

/// Range over mean up to which spectra can still be read as of one speed: ISO 3095 holds a test run to ± 5 %.
constexpr double kOneSpeed = 0.1;

Fault of_speed(FaultKind kind, Severity severity, std::string says, double value, std::string unit, double p) {
    Fault found;
    found.kind = kind;
    found.severity = severity;
    found.says = std::move(says);
    found.value = value;
    found.unit = std::move(unit);
    found.false_alarm = p;
    return found;
}

Fault changes(const std::string& by, double from, double to, double low, double high, double mean, double p) {
    const double range = (high - low) / mean;
    return of_speed(
        FaultKind::speed_changes, range > kOneSpeed ? Severity::error : Severity::warning,
        fmt::format("by {} the speed runs from {:.4g} m/s at the begin to {:.4g} m/s at the end, between {:.4g} and "
                    "{:.4g} m/s ({:.1f} %): lines are smeared and spectra mix speeds",
                    by, from, to, low, high, 100.0 * range),
        range, "1", p);
}

void check_speed_channel(const Evidence& evidence, std::vector<Fault>& faults) {
    std::vector<double> speed;
    for (const double v : evidence.series().speed_m_per_s)
        if (std::isfinite(v)) speed.push_back(v);
    if (speed.size() < 100) return;
    const double first = speed.front(), last = speed.back();
    std::sort(speed.begin(), speed.end());
    const double low = speed[speed.size() / 100], high = speed[speed.size() - 1 - speed.size() / 100],
                 middle = speed[speed.size() / 2];
    if (middle <= 0.0 || (high - low) / middle < 0.01) return;
    faults.push_back(changes("the speed channel", first, last, low, high, middle, 0.0));
}

/// By the delays along the record.
void check_running_speed(const Evidence& evidence, std::vector<Fault>& faults) {
    constexpr double kLeast = 0.01;  // of the mean: what a channel is held to as well
    if (!evidence.running) return;
    const std::vector<double>& speeds = evidence.running->path.speed_m_per_s;
    const auto [low, high] = std::minmax_element(speeds.begin(), speeds.end());
    const double mean = evidence.running->path.mean_m_per_s(), range = (*high - *low) / mean;
    // Lowest and highest of some tens of windows lie four standard deviations of chance apart.
    constexpr double kByChance = 8.0;
    if (range < kLeast || range < kByChance * evidence.running->relative_error) return;
    faults.push_back(
        changes("the delays between the channels", speeds.front(), speeds.back(), *low, *high, mean, false_alarm));
}

/// What a stated speed was taken for, by its ratio to the one that the delays say; "" when no mistake is known.
std::string mistaken_unit(double ratio) {
    struct Mistake {
        double ratio;
        const char* says;
    };
    constexpr std::array<Mistake, 6> mistakes = {{{3.6, "km/h taken for m/s"},
                                                  {1.0 / 3.6, "m/s taken for km/h"},
                                                  {1.0 / 0.44704, "miles per hour taken for m/s"},
                                                  {0.44704, "m/s taken for miles per hour"},
                                                  {1.0 / 1.609344, "miles per hour taken for km/h"},
                                                  {1.609344, "km/h taken for miles per hour"}}};
    constexpr double kClose = 0.03;  // a twentieth of the distance between two mistakes
    for (const Mistake& mistake : mistakes)
        if (std::abs(ratio / mistake.ratio - 1.0) < kClose) return fmt::format(": most likely {}", mistake.says);
    return "";
}

void check_stated_speed(const Evidence& evidence, std::vector<Fault>& faults) {
    const StatedSpeed stated = stated_speed(evidence.recording);
    if (!evidence.speed || stated.m_per_s <= 0.0) return;
    const double found = evidence.speed->speed_m_per_s;
    // A speed that the train had is not another one than stated: that it changes is told already.
    if (evidence.running) {
        const std::vector<double>& speeds = evidence.running->path.speed_m_per_s;
        const auto [low, high] = std::minmax_element(speeds.begin(), speeds.end());
        if (stated.m_per_s >= *low && stated.m_per_s <= *high) return;
    }
    const double error =
        std::hypot(evidence.speed->standard_error_m_per_s, std::max(stated.standard_error, 5e-4 * stated.m_per_s));
    const double difference = found - stated.m_per_s, z = std::abs(difference) / error;
    // The geometry of the believed vehicle enters as well: less than half a percent is not held against the stated
    // speed.
    constexpr double kDeviations = 3.3;  // one record in a thousand
    if (z < kDeviations || std::abs(difference) < 0.005 * stated.m_per_s) return;
    faults.push_back(
        of_speed(FaultKind::speed_mismatch, Severity::error,
                 fmt::format("stated are {:.4g} m/s{}, the delays between the channels say {:.4g} ± {:.2g} m/s{}",
                             stated.m_per_s, stated.from_channel ? " by the speed channel" : "", found,
                             1.645 * evidence.speed->standard_error_m_per_s, mistaken_unit(stated.m_per_s / found)),
                 difference, "m/s", 2.0 * normal_exceeded(z)));
}

}  // namespace

void check_speed(const Evidence& evidence, std::vector<Fault>& faults) {
    check_speed_channel(evidence, faults);
    if (evidence.series().speed_m_per_s.empty()) check_running_speed(evidence, faults);
    check_stated_speed(evidence, faults);
}

}  // namespace railpem::recordings::checks
