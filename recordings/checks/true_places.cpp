#include "recordings/checks/true_places.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "recordings/checks/body_as_rigid.hpp"
#include "recordings/checks/false_alarm.hpp"
#include "recordings/checks/median.hpp"
#include "recordings/estimates/meeting_order.hpp"

namespace railpem::recordings::checks {
namespace {

/// Channels that meet the same track one after the other.
struct Group {
    std::vector<std::size_t> members;
    std::vector<double> places_m;

    double longest_m() const {
        const auto [least, most] = std::minmax_element(places_m.begin(), places_m.end());
        return *most - *least;
    }
};

/// What a group shows: who stands where, and how fast it runs.
struct GroupOrder {
    Group group;
    std::vector<std::size_t> stands_at;  ///< member i stands where member stands_at[i] is described
    std::vector<double> speed_m_per_s;   ///< per window of MeetingCorrelations; empty: nothing is met
    bool reversed() const {
        for (std::size_t i = 0; i < stands_at.size(); ++i)
            if (stands_at[i] + i + 1 != stands_at.size()) return false;
        return true;
    }
};

/// An order is taken for another than described when it is met half as well again …
constexpr double kClearlyBetter = 1.5;
/// … and as well as a third of what channels without noise or coupling would show: unrelated ones reach a tenth.
constexpr double kMet = 0.1;

std::vector<Group> groups_of(const TimeSeries& series, const VehicleGeometry& geometry, Location location) {
    std::vector<Group> groups;
    std::vector<std::size_t> seen;
    for (std::size_t i = 0; i < series.channels.size(); ++i) {
        const ChannelDescription& own = series.channels[i].description;
        if (own.location != location || std::find(seen.begin(), seen.end(), i) != seen.end()) continue;
        Group group;
        for (std::size_t j = i; j < series.channels.size(); ++j) {
            const ChannelDescription& other = series.channels[j].description;
            const auto place = place_along(other, geometry);
            if (other.location != location || other.quantity != own.quantity || other.side != own.side || !place)
                continue;
            seen.push_back(j);
            if (std::find(group.places_m.begin(), group.places_m.end(), *place) != group.places_m.end()) continue;
            group.members.push_back(j);
            group.places_m.push_back(*place);
        }
        constexpr std::size_t kMost = 6;  // 720 orders
        if (group.members.size() >= 2 && group.members.size() <= kMost) groups.push_back(std::move(group));
    }
    // From the front, so that the reverse order is the train's from the rear.
    for (Group& group : groups) {
        std::vector<std::size_t> order(group.members.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::sort(order.begin(), order.end(),
                  [&](std::size_t a, std::size_t b) { return group.places_m[a] > group.places_m[b]; });
        const Group as_described = group;
        for (std::size_t i = 0; i < order.size(); ++i) {
            group.members[i] = as_described.members[order[i]];
            group.places_m[i] = as_described.places_m[order[i]];
        }
    }
    return groups;
}

MeetingCorrelations correlations_of(const Group& group, const std::vector<std::vector<double>>& detrended, double rate,
                                    const MeetingOptions& options) {
    std::vector<std::vector<double>> samples;
    for (const std::size_t member : group.members) samples.push_back(detrended[member]);
    return meeting_correlations(samples, rate, group.longest_m(), options);
}

/// The best of all orders of a group.
GroupOrder order_of(const Group& group, const std::vector<std::vector<double>>& detrended, double rate) {
    const MeetingCorrelations correlations = correlations_of(group, detrended, rate, {});
    GroupOrder result{.group = group, .stands_at = std::vector<std::size_t>(group.members.size()), .speed_m_per_s = {}};
    std::iota(result.stands_at.begin(), result.stands_at.end(), std::size_t{0});
    const MeetingScore described = meeting_score(correlations, group.places_m);
    MeetingScore best = described;
    std::vector<std::size_t> order = result.stands_at, best_order = order;
    while (std::next_permutation(order.begin(), order.end())) {
        std::vector<double> places;
        for (const std::size_t at : order) places.push_back(group.places_m[at]);
        MeetingScore score = meeting_score(correlations, places);
        if (score.correlation > best.correlation) {
            best = std::move(score);
            best_order = order;
        }
    }
    if (best.correlation > kMet && best.correlation > kClearlyBetter * described.correlation)
        result.stands_at = best_order;
    else
        best = described;
    if (best.correlation > kMet) result.speed_m_per_s = best.speed_m_per_s;
    return result;
}

/// A pair at speeds that are known: is the one that is described in front met first?
GroupOrder order_of_pair(const Group& pair, const std::vector<std::vector<double>>& detrended, double rate,
                         const std::vector<double>& speeds, const MeetingOptions& options) {
    const MeetingCorrelations correlations = correlations_of(pair, detrended, rate, options);
    GroupOrder result{.group = pair, .stands_at = {0, 1}, .speed_m_per_s = {}};
    const double described = correlation_at(correlations, pair.places_m, speeds),
                 exchanged = correlation_at(correlations, {pair.places_m[1], pair.places_m[0]}, speeds);
    if (exchanged > kMet && exchanged > kClearlyBetter * described) result.stands_at = {1, 0};
    return result;
}

/// The outermost two channels on the body, one before and one behind its centre.
std::optional<Group> body_ends(const std::vector<ChannelDescription>& channels) {
    Group ends{.members = {0, 0}, .places_m = {0.0, 0.0}};
    constexpr double kFromCentre = 2.0;  // m; nearer, both ends are met at once
    for (std::size_t i = 0; i < channels.size(); ++i) {
        if (channels[i].location != Location::body || channels[i].quantity != ChannelQuantity::acceleration) continue;
        const double place = channels[i].position_m;
        if (place > std::max(kFromCentre, ends.places_m[0])) ends.members[0] = i, ends.places_m[0] = place;
        if (place < std::min(-kFromCentre, ends.places_m[1])) ends.members[1] = i, ends.places_m[1] = place;
    }
    if (ends.places_m[0] == 0.0 || ends.places_m[1] == 0.0) return std::nullopt;
    return ends;
}

void take_place(const ChannelDescription& described, ChannelDescription& channel) {
    channel.location = described.location;
    channel.index = described.index;
    channel.side = described.side;
    channel.position_m = described.position_m;
}

Fault exchange(std::vector<std::string> channels, std::string says) {
    Fault found;
    found.kind = FaultKind::swapped;
    found.severity = Severity::error;
    found.channels = std::move(channels);
    found.says = std::move(says);
    found.unit = "1";
    found.false_alarm = false_alarm;
    return found;
}

/// Puts the members of a group where they stand, and names those that were elsewhere.
std::vector<std::string> put_right(const GroupOrder& order, const TimeSeries& series,
                                   std::vector<ChannelDescription>& channels) {
    const std::vector<ChannelDescription> before = channels;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < order.stands_at.size(); ++i) {
        if (order.stands_at[i] == i) continue;
        const std::size_t member = order.group.members[i];
        take_place(before[order.group.members[order.stands_at[i]]], channels[member]);
        names.push_back(series.channels[member].description.name);
    }
    return names;
}

/// "a sits where b is described, b sits where a is described"
std::string seats(const GroupOrder& order, const TimeSeries& series) {
    std::vector<std::string> words;
    for (std::size_t i = 0; i < order.stands_at.size(); ++i)
        if (order.stands_at[i] != i)
            words.push_back(fmt::format("{} sits where {} is described",
                                        series.channels[order.group.members[i]].description.name,
                                        series.channels[order.group.members[order.stands_at[i]]].description.name));
    return fmt::format("{}", fmt::join(words, ", "));
}

/// Centre and an end of the body exchanged: the one that the other two have between them is called an end.
void centre_of_body(const CrossSpectra& spectra, const TimeSeries& series, TruePlaces& places) {
    const auto body = body_channels(spectra);
    if (!body) return;
    constexpr double kExplained = 0.9, kHalf = 0.2;  // a body that bends a little, and gains a few per cent off
    const auto is_centre = [&](std::size_t i) {
        const auto& c = body->front_centre_rear;
        const auto fit = rigid_fit(spectra, c[i], c[(i + 1) % 3], c[(i + 2) % 3]);
        return fit && fit->explained > kExplained && std::abs(std::abs(fit->a) - 0.5) < kHalf &&
               std::abs(std::abs(fit->b) - 0.5) < kHalf;
    };
    if (is_centre(1) || is_centre(0) == is_centre(2)) return;
    const std::size_t centre = body->front_centre_rear[1], end = body->front_centre_rear[is_centre(0) ? 0 : 2];
    const ChannelDescription described = series.channels[centre].description;
    take_place(series.channels[end].description, places.channels[centre]);
    take_place(described, places.channels[end]);
    places.exchanges.push_back(
        exchange({described.name, series.channels[end].description.name},
                 fmt::format("below 5 Hz {} moves with the mean of the two others on the body: it sits at the centre, "
                             "where {} is described: the channels are exchanged",
                             series.channels[end].description.name, described.name)));
}

/// What all groups say together: either the train runs the other way, or some channels are exchanged.
void tell(const std::vector<GroupOrder>& orders, const TimeSeries& series, TruePlaces& places) {
    const bool backwards = !orders.empty() && std::all_of(orders.begin(), orders.end(),
                                                          [](const GroupOrder& order) { return order.reversed(); });
    std::vector<std::string> all;
    for (const GroupOrder& order : orders) {
        std::vector<std::string> names = put_right(order, series, places.channels);
        if (names.empty()) continue;
        if (backwards)
            all.insert(all.end(), names.begin(), names.end());
        else
            places.exchanges.push_back(
                exchange(names, fmt::format("by the delays with which they meet the track {}{}", seats(order, series),
                                            order.reversed() && names.size() > 2 ? ": the numbering runs from the rear"
                                                                                 : ": the channels are exchanged")));
    }
    if (all.empty()) return;
    places.exchanges.push_back(
        exchange(all, fmt::format("by the delays with which they meet the track {}: {}", seats(orders.front(), series),
                                  all.size() == 2 ? "the channels are exchanged, or the train ran backwards"
                                                  : "the numbering runs from the rear, or the train ran backwards")));
}

}  // namespace

TruePlaces true_places(const TimeSeries& series, const InspectionContext& context,
                       const std::vector<std::vector<double>>& detrended, const CrossSpectra* spectra) {
    TruePlaces places;
    for (const Channel& channel : series.channels) places.channels.push_back(channel.description);
    if (spectra) centre_of_body(*spectra, series, places);
    if (!context.geometry) return places;
    std::vector<GroupOrder> orders;
    std::vector<double> speeds;
    for (const Location location : {Location::wheel, Location::bogie})
        for (const Group& group : groups_of(series, *context.geometry, location)) {
            orders.push_back(speeds.empty() || group.members.size() > 2
                                 ? order_of(group, detrended, series.sampling_rate_hz)
                                 : order_of_pair(group, detrended, series.sampling_rate_hz, speeds, {}));
            if (speeds.empty()) speeds = orders.back().speed_m_per_s;
        }
    if (speeds.empty()) return places;
    places.speed_m_per_s = median(speeds);
    // A body on its secondary suspension is still below what its bending begins with, and needs longer windows for it.
    const MeetingOptions slow{.from_hz = 0.7, .to_hz = 6.0, .window_s = 6.0};
    if (const auto ends = body_ends(places.channels))
        orders.push_back(order_of_pair(*ends, detrended, series.sampling_rate_hz, speeds, slow));
    tell(orders, series, places);
    return places;
}

}  // namespace railpem::recordings::checks
