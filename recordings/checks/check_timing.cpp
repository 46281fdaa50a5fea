#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>

#include "recordings/checks/checks.hpp"
#include "recordings/estimates/confidence.hpp"

namespace railpem::recordings::checks {
namespace {

/// Delays of all pairs as observations of one slowness, and of one channel's offset or none.
struct Fit {
    double slowness = 0.0, offset = 0.0, offset_error = 0.0, chi_squared = 0.0;
};

double pair_error(const PairDelay& pair) {
    // The ripple that the rail's coupling of neighbouring wheels puts on the phase is not all in the standard error: no
    // delay is believed better than 50 µs, or 0.02 % of itself (speed changes within the record).
    return std::hypot(pair.delay.standard_error_s, std::hypot(50e-6, 2e-4 * pair.delay.seconds));
}

Fit fit(const std::vector<PairDelay>& pairs, std::ptrdiff_t skewed) {
    const auto rows = static_cast<Eigen::Index>(pairs.size());
    const Eigen::Index columns = skewed >= 0 ? 2 : 1;
    Eigen::MatrixXd design(rows, columns);
    Eigen::VectorXd observed(rows);
    for (Eigen::Index r = 0; r < rows; ++r) {
        const PairDelay& pair = pairs[static_cast<std::size_t>(r)];
        const double weight = 1.0 / pair_error(pair);
        design(r, 0) = weight * pair.distance_m;
        if (columns > 1)
            design(r, 1) = weight * (static_cast<std::ptrdiff_t>(pair.rear) == skewed    ? 1.0
                                     : static_cast<std::ptrdiff_t>(pair.front) == skewed ? -1.0
                                                                                         : 0.0);
        observed[r] = weight * pair.delay.seconds;
    }
    const Eigen::MatrixXd normal = design.transpose() * design;
    if (normal.fullPivLu().rank() < columns) return {0.0, 0.0, 0.0, 1e300};
    const Eigen::VectorXd solution = normal.ldlt().solve(design.transpose() * observed);
    Fit result;
    result.slowness = solution[0];
    if (columns > 1) {
        result.offset = solution[1];
        result.offset_error = std::sqrt(normal.inverse()(1, 1));
    }
    result.chi_squared = (observed - design * solution).squaredNorm();
    return result;
}

Fault skew(std::vector<std::string> channels, double offset, double error, double p, const std::string& how) {
    Fault found;
    found.kind = FaultKind::timing_skew;
    found.severity = Severity::error;
    found.says = fmt::format("{:.3f} ms {} (± {:.3f}), {}", 1e3 * std::abs(offset), offset > 0.0 ? "late" : "early",
                             1.645e3 * error, how);
    found.channels = std::move(channels);
    found.value = offset;
    found.unit = "s";
    found.false_alarm = p;
    return found;
}

/// Channels at one place on both sides of the train see the same delay: anything between them is skew.
void check_same_place(const Evidence& evidence, double least, std::vector<Fault>& faults) {
    const auto& channels = evidence.series().channels;
    for (std::size_t i = 0; i < channels.size(); ++i)
        for (std::size_t j = i + 1; j < channels.size(); ++j) {
            const ChannelDescription &a = channels[i].description, &b = channels[j].description;
            if (a.location == Location::none || a.location == Location::body || a.location != b.location ||
                a.index != b.index || a.quantity != b.quantity)
                continue;
            const Delay delay = estimate_delay(evidence.slow(i), evidence.slow(j), evidence.slow_rate_hz(),
                                               {.least_s = -0.2, .most_s = 0.2});
            const double error = std::hypot(delay.standard_error_s, 50e-6);
            // The two rails are not alike: only a clear common part says anything.
            if (!delay.found || delay.correlation < 0.5 || std::abs(delay.seconds) < std::max(least, 6.0 * error))
                continue;
            faults.push_back(skew({b.name, a.name}, delay.seconds, error,
                                  normal_exceeded(std::abs(delay.seconds) / error),
                                  fmt::format("{} against {} at the same place", b.name, a.name)));
        }
}

}  // namespace

void check_timing(const Evidence& evidence, std::vector<Fault>& faults) {
    const double least = std::max(3e-4, 0.3 / evidence.series().sampling_rate_hz);
    check_same_place(evidence, least, faults);
    std::vector<PairDelay> pairs;
    for (const PairDelay& pair : evidence.delays)
        if (pair.delay.seconds > 0.0) pairs.push_back(pair);
    if (pairs.size() < 3) return;  // one slowness and one offset fit two delays exactly
    const Fit without = fit(pairs, -1);
    std::map<double, std::pair<std::size_t, Fit>> candidates;  // by misfit
    for (const PairDelay& pair : pairs)
        for (const std::size_t channel : {pair.front, pair.rear}) {
            const Fit with = fit(pairs, static_cast<std::ptrdiff_t>(channel));
            candidates.emplace(with.chi_squared, std::pair(channel, with));
        }
    const auto& [channel, best] = candidates.begin()->second;
    const double gain = without.chi_squared - best.chi_squared;
    // Delays share channels, so gains are not exactly χ²₁: 36 is six standard deviations.
    if (gain < 36.0 || std::abs(best.offset) < least) return;
    // One skew explains what is left of all delays. Where much stays, their speed or their distances are not known, and
    // nothing follows for a single channel.
    constexpr double kLeft = 0.1;
    if (best.chi_squared > std::max(25.0, kLeft * without.chi_squared)) return;
    const auto told = [&](const Fault& fault) {
        return fault.kind == FaultKind::clock_drift && fault.channels.front() == evidence.name(channel);
    };
    if (std::any_of(faults.begin(), faults.end(), told)) return;
    std::vector<std::string> names = {evidence.name(channel)};
    std::string how =
        fmt::format("after {:.4g} m/s × distance is taken off all delays; it does not scale with the distance",
                    1.0 / best.slowness);
    for (auto next = std::next(candidates.begin()); next != candidates.end(); ++next)
        if (next->first - best.chi_squared < 9.0) {  // cannot be told apart
            names.push_back(evidence.name(next->second.first));
            if (names.size() == 2) how += ", or the opposite in another channel named here";
        }
    faults.push_back(skew(std::move(names), best.offset, best.offset_error, chi_squared_exceeded(gain, 1.0), how));
}

}  // namespace railpem::recordings::checks
