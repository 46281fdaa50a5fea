#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "recordings/estimates/delay.hpp"
#include "recordings/recording.hpp"

namespace railpem::recordings {

/// Where the wheels and bogies of the believed vehicle stand: m from the centre of the body, positive towards the
/// front.
struct VehicleGeometry {
    std::array<double, 4> wheels_m{};
    std::array<double, 2> bogies_m{};
};

/// One delay between two channels that meet the same track.
struct PairDelay {
    std::size_t front = 0, rear = 0;  ///< indices into TimeSeries::channels
    double distance_m = 0.0;
    Delay delay;
};

/// The speed that the recording itself shows.
struct WheelbaseSpeed {
    double speed_m_per_s = 0.0;
    double standard_error_m_per_s = 0.0;
    std::vector<PairDelay> pairs;  ///< all that were found, used or not
    int pairs_used = 0;
};

struct SpeedRange {
    double least_m_per_s = 5.0;
    double most_m_per_s = 120.0;
};

/// Two channels of one kind, at two places along one rail: one shows later what the other did.
bool meet_alike(const ChannelDescription& a, const ChannelDescription& b);

/// Place of a channel along the track, m from the centre of the body; nothing where it has none.
std::optional<double> place_along(const ChannelDescription& channel, const VehicleGeometry& geometry);

/// Distance between the places of two channels, first minus second; nothing when either has no place along the track.
std::optional<double> distance_between(const ChannelDescription& first, const ChannelDescription& second,
                                       const VehicleGeometry& geometry);

/// Delays of all pairs of axle boxes and of bogies (same side where sides are stated). With a nearly known speed the
/// search is narrow: pass its range.
std::vector<PairDelay> wheelbase_delays(const TimeSeries& series, const VehicleGeometry& geometry,
                                        const SpeedRange& range);

/// Slowness 1/v as the weighted mean of delay/distance over the pairs; the error is enlarged by √(χ²/n) when they
/// disagree. A single pair that disagrees with all others by more than five standard errors (a skewed channel) is left
/// out with its partner's other pairs kept. Nothing when no pair was found.
std::optional<WheelbaseSpeed> wheelbase_speed(std::vector<PairDelay> pairs);

}  // namespace railpem::recordings
