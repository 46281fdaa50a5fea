#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>

#include "recordings/checks/checks.hpp"
#include "recordings/estimates/confidence.hpp"
#include "recordings/estimates/laid_delays.hpp"

namespace railpem::recordings::checks {
namespace {

/// What is left of a pair's delay in one part of the record, with the channels laid on the track.
struct PartDelay {
    std::size_t part = 0, front = 0, rear = 0;
    double distance_m = 0.0, time_s = 0.0;  ///< time: of the middle of the part
    double left_s = 0.0, error_s = 0.0;
};

/// Delays as observations of one slowness in every part, and of one channel's offset and drift.
struct ClockFit {
    double rate = 0.0, rate_error = 0.0, chi_squared = 0.0;
};

std::vector<double> part_of(const std::vector<double>& samples, std::size_t part, std::size_t count) {
    const auto at = [&](std::size_t p) {
        return samples.begin() + static_cast<std::ptrdiff_t>(p * samples.size() / count);
    };
    return {at(part), at(part + 1)};
}

/// Parts long enough for a delay to be known to a twentieth of a millisecond, eight at most.
std::vector<PartDelay> part_delays(const Evidence& evidence) {
    const VehicleGeometry& geometry = *evidence.context.geometry;
    const double rate = evidence.series().sampling_rate_hz;
    const auto from = static_cast<std::size_t>(std::lround(evidence.moving.from_s * rate)),
               to = std::min(evidence.series().size(),
                             static_cast<std::size_t>(std::lround(evidence.moving.to_s * rate)));
    std::vector<std::vector<double>> laid(evidence.detrended.size());
    for (const PairDelay& pair : evidence.delays)
        for (const std::size_t i : {pair.front, pair.rear})
            if (laid[i].empty())
                laid[i] = laid_on_track({evidence.detrended[i].begin() + static_cast<std::ptrdiff_t>(from),
                                         evidence.detrended[i].begin() + static_cast<std::ptrdiff_t>(to)},
                                        rate, *place_along(evidence.series().channels[i].description, geometry),
                                        evidence.running->path);
    constexpr double kPart_s = 8.0, kReach_s = 0.5;
    const double highest_hz = RunningSpeedOptions{}.to_hz;  // as in laid_delays()
    const double duration = static_cast<double>(to - from) / rate;
    const std::size_t count = std::min<std::size_t>(8, static_cast<std::size_t>(duration / kPart_s));
    std::vector<PartDelay> delays;
    for (const PairDelay& pair : evidence.delays)
        for (std::size_t part = 0; part < count; ++part) {
            const Delay delay =
                estimate_delay(part_of(laid[pair.front], part, count), part_of(laid[pair.rear], part, count), rate,
                               {.least_s = -kReach_s, .most_s = kReach_s, .to_hz = highest_hz, .window_s = 1.0});
            if (!delay.found) continue;
            const double time = (static_cast<double>(part) + 0.5) * duration / static_cast<double>(count);
            // As in check_timing(): no delay is believed better than 50 µs.
            delays.push_back({part, pair.front, pair.rear, pair.distance_m, time - 0.5 * duration, delay.seconds,
                              std::hypot(delay.standard_error_s, 50e-6)});
        }
    return delays;
}

/// `channel`: whose clock is asked about; `drifts`: false for an offset alone. Nothing when it cannot be told.
std::optional<ClockFit> fit_clock(const std::vector<PartDelay>& delays, std::size_t parts, std::size_t channel,
                                  bool drifts) {
    const auto rows = static_cast<Eigen::Index>(delays.size()), slowness = static_cast<Eigen::Index>(parts);
    Eigen::MatrixXd design = Eigen::MatrixXd::Zero(rows, slowness + (drifts ? 2 : 1));
    Eigen::VectorXd observed(rows);
    for (Eigen::Index r = 0; r < rows; ++r) {
        const PartDelay& delay = delays[static_cast<std::size_t>(r)];
        const double weight = 1.0 / delay.error_s, sign = delay.rear == channel    ? 1.0
                                                          : delay.front == channel ? -1.0
                                                                                   : 0.0;
        design(r, static_cast<Eigen::Index>(delay.part)) = weight * delay.distance_m;
        design(r, slowness) = weight * sign;
        if (drifts) design(r, slowness + 1) = weight * sign * delay.time_s;
        observed[r] = weight * delay.left_s;
    }
    const Eigen::MatrixXd normal = design.transpose() * design;
    const Eigen::FullPivLU<Eigen::MatrixXd> inverse(normal);
    if (inverse.rank() < normal.rows()) return std::nullopt;
    const Eigen::VectorXd solution = inverse.solve(design.transpose() * observed);
    ClockFit fit;
    if (drifts) {
        fit.rate = solution[slowness + 1];
        fit.rate_error = std::sqrt(inverse.inverse()(slowness + 1, slowness + 1));
    }
    fit.chi_squared = (observed - design * solution).squaredNorm();
    return fit;
}

}  // namespace

void check_clock(const Evidence& evidence, std::vector<Fault>& faults) {
    if (!evidence.running || !evidence.context.geometry || evidence.delays.size() < 3) return;
    const std::vector<PartDelay> delays = part_delays(evidence);
    std::size_t parts = 0;
    for (const PartDelay& delay : delays) parts = std::max(parts, delay.part + 1);
    if (parts < 3) return;
    double without = 1e300, best_chi = 1e300;
    std::size_t culprit = 0;
    ClockFit best;
    for (std::size_t channel = 0; channel < evidence.series().channels.size(); ++channel) {
        if (std::none_of(delays.begin(), delays.end(),
                         [&](const PartDelay& delay) { return delay.front == channel || delay.rear == channel; }))
            continue;
        const auto still = fit_clock(delays, parts, channel, false), drifting = fit_clock(delays, parts, channel, true);
        if (still) without = std::min(without, still->chi_squared);
        if (!drifting || drifting->chi_squared >= best_chi) continue;
        best_chi = drifting->chi_squared;
        best = *drifting;
        culprit = channel;
    }
    const double duration = evidence.moving.to_s - evidence.moving.from_s, gain = without - best_chi,
                 least = std::max(3e-4, 0.3 / evidence.series().sampling_rate_hz);
    // As in check_timing(): six deviations, and a drift that explains what it is blamed for.
    constexpr double kLeft = 0.2;
    if (gain < 36.0 || std::abs(best.rate) * duration < least || best_chi > std::max(25.0, kLeft * without)) return;
    Fault found;
    found.kind = FaultKind::clock_drift;
    found.severity = Severity::error;
    found.channels = {evidence.name(culprit)};
    found.says = fmt::format(
        "its delays grow by {:.3g} ppm (± {:.2g}) against the other channels, {:.3g} ms over the record: its clock "
        "runs {} than theirs",
        1e6 * best.rate, 1.645e6 * best.rate_error, 1e3 * best.rate * duration, best.rate > 0.0 ? "faster" : "slower");
    found.value = 1e6 * best.rate;
    found.unit = "ppm";
    found.false_alarm = chi_squared_exceeded(gain, 1.0);
    faults.push_back(std::move(found));
}

}  // namespace railpem::recordings::checks
