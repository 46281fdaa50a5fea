#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "recordings/checks/checks.hpp"

namespace railpem::recordings::checks {
namespace {

Fault about(FaultKind kind, std::vector<std::string> channels, std::string says, double value, double p) {
    Fault found;
    found.kind = kind;
    found.severity = Severity::error;
    found.channels = std::move(channels);
    found.says = std::move(says);
    found.value = value;
    found.unit = "1";
    found.false_alarm = p;
    return found;
}

void check_duplicates(const Evidence& evidence, std::vector<Fault>& faults) {
    constexpr std::size_t kFewest = 100;  // of fewer samples any two agree
    const auto& x = evidence.detrended;
    for (std::size_t i = 0; i < x.size(); ++i)
        for (std::size_t j = 0; j < i && x[i].size() >= kFewest; ++j) {
            double ii = 0.0, jj = 0.0, ij = 0.0;
            for (std::size_t n = 0; n < x[i].size(); ++n) {
                ii += x[i][n] * x[i][n];
                jj += x[j][n] * x[j][n];
                ij += x[i][n] * x[j][n];
            }
            if (ii <= 0.0 || jj <= 0.0) continue;
            // Two sensors at two places never agree to a ten-thousandth of their power.
            const double left = 1.0 - ij * ij / (ii * jj);
            if (left < 1e-4)
                faults.push_back(
                    about(FaultKind::duplicated, {evidence.name(j), evidence.name(i)},
                          fmt::format("{} is {:.4g} × {} but for {:.1e} of its power: one sensor recorded twice",
                                      evidence.name(i), ij / jj, evidence.name(j), std::max(0.0, left)),
                          ij / jj, 0.0));
        }
}

/// Which wheel a channel is, judged by the delays: the order of the axle boxes that fits best, over all orders.
void check_order(const Evidence& evidence, std::vector<Fault>& faults) {
    if (!evidence.context.geometry) return;
    std::vector<std::size_t> members;
    for (const PairDelay& pair : evidence.delays)
        for (const std::size_t channel : {pair.front, pair.rear})
            if (evidence.series().channels[channel].description.location == Location::wheel &&
                std::find(members.begin(), members.end(), channel) == members.end())
                members.push_back(channel);
    if (members.size() < 2 || members.size() > 6) return;
    std::sort(members.begin(), members.end());
    std::vector<double> places;
    for (const std::size_t channel : members)
        places.push_back(
            evidence.context.geometry
                ->wheels_m[static_cast<std::size_t>(evidence.series().channels[channel].description.index - 1)]);
    std::vector<std::size_t> order(members.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    // Misfit of an order: delays against one positive slowness times the distances it implies.
    double slowness = 0.0;  // of the order asked about last
    const auto misfit = [&](const std::vector<std::size_t>& assigned) {
        double xx = 0.0, xy = 0.0, yy = 0.0;
        for (const PairDelay& pair : evidence.delays) {
            const auto a = std::find(members.begin(), members.end(), pair.front),
                       b = std::find(members.begin(), members.end(), pair.rear);
            if (a == members.end() || b == members.end()) continue;
            const double distance = places[assigned[static_cast<std::size_t>(a - members.begin())]] -
                                    places[assigned[static_cast<std::size_t>(b - members.begin())]];
            xx += distance * distance;
            xy += distance * pair.delay.seconds;
            yy += pair.delay.seconds * pair.delay.seconds;
        }
        slowness = xx > 0.0 ? xy / xx : 0.0;
        return xy > 0.0 ? 1.0 - xy * xy / (xx * yy) : 1.0;
    };
    const double as_described = misfit(order);
    double best = as_described;
    std::vector<std::size_t> best_order = order, assigned = order;
    while (std::next_permutation(assigned.begin(), assigned.end())) {
        const double value = misfit(assigned);
        if (value < best) {
            best = value;
            best_order = assigned;
        }
    }
    // A sound order leaves less than a ten-thousandth; a swap of two neighbours leaves more than a hundredth.
    if (as_described < 0.005 || best > 0.2 * as_described) return;
    // As few pairs as one fit some order at any delay. An axle that resonates gives such delays: they say another speed
    // than the bogies do.
    constexpr double kSameSpeed = 0.05;
    const auto is_of_wheels = [&](const PairDelay& pair) {
        return std::find(members.begin(), members.end(), pair.front) != members.end();
    };
    const auto pairs =
        static_cast<std::size_t>(std::count_if(evidence.delays.begin(), evidence.delays.end(), is_of_wheels));
    misfit(best_order);
    if (pairs < members.size() && evidence.speed &&
        std::abs(slowness * evidence.speed->speed_m_per_s - 1.0) > kSameSpeed)
        return;
    std::vector<std::string> names;
    std::string says;
    for (std::size_t i = 0; i < members.size(); ++i)
        if (best_order[i] != order[i]) {
            names.push_back(evidence.name(members[i]));
            says += fmt::format("{}{} sits where {} is described", says.empty() ? "" : ", ", evidence.name(members[i]),
                                evidence.name(members[best_order[i]]));
        }
    faults.push_back(about(FaultKind::swapped, names,
                           "by the delays between the axle boxes " + says +
                               (names.size() == members.size() && members.size() > 2
                                    ? ": the numbering runs from the rear, or the train ran backwards"
                                    : ""),
                           0.0, false_alarm));
}

/// Above 20 Hz every suspension makes the next mass quieter: wheel, bogie, body.
void check_roughness(const Evidence& evidence, std::vector<Fault>& faults) {
    const CrossSpectra& spectra = *evidence.spectra;
    constexpr double kNothing_db = -250.0;  // a channel that stands still is said to, and is no measure of others
    const auto level = [&](std::size_t channel) {
        double sum = 0.0;
        for (std::size_t k = 1; k < spectra.bins(); ++k)
            if (spectra.frequency_hz[k] >= 20.0 &&
                spectra.frequency_hz[k] <= std::min(100.0, 0.4 * spectra.sampling_rate_hz))
                sum += spectra.psd(k, channel);
        return 10.0 * std::log10(std::max(sum, 1e-300));
    };
    const auto rank = [](Location location) {
        return location == Location::body ? 1 : location == Location::bogie ? 2 : location == Location::wheel ? 3 : 0;
    };
    for (std::size_t i = 0; i < spectra.size(); ++i)
        for (std::size_t j = 0; j < spectra.size(); ++j) {
            const ChannelDescription &quiet = spectra.channels[i], &rough = spectra.channels[j];
            if (rank(quiet.location) == 0 || rank(quiet.location) >= rank(rough.location) ||
                quiet.quantity != ChannelQuantity::acceleration || rough.quantity != ChannelQuantity::acceleration)
                continue;
            if (quiet.scale == Scale::unknown || rough.scale == Scale::unknown) continue;
            const double difference = level(i) - level(j);
            if (difference < 6.0 || level(j) < kNothing_db) continue;
            // Said of the pair that differs most, not of every pair that the same swap disturbs.
            bool largest = true;
            for (std::size_t k = 0; k < spectra.size() && largest; ++k)
                if (rank(spectra.channels[k].location) == rank(rough.location)) largest = level(j) <= level(k);
            for (std::size_t k = 0; k < spectra.size() && largest; ++k)
                if (rank(spectra.channels[k].location) == rank(quiet.location)) largest = level(i) >= level(k);
            if (largest)
                faults.push_back(about(
                    FaultKind::swapped, {quiet.name, rough.name},
                    fmt::format(
                        "{} is {:.0f} dB rougher than {} above 20 Hz: the channels are swapped, or a unit is wrong",
                        quiet.name, difference, rough.name),
                    difference, false_alarm));
        }
}

}  // namespace

void check_channels(const Evidence& evidence, std::vector<Fault>& faults) {
    check_duplicates(evidence, faults);
    check_order(evidence, faults);
    if (evidence.spectra) check_roughness(evidence, faults);
}

}  // namespace railpem::recordings::checks
