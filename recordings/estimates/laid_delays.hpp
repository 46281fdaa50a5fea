#pragma once
// Delays between channels of a train whose speed changes.

#include <vector>

#include "recordings/estimates/track_path.hpp"
#include "recordings/estimates/wheelbase_speed.hpp"

namespace railpem::recordings {

/// Samples of a channel at `place_m`, each at the time in which the middle of the body is where the channel was: what
/// two channels meet of the track then stands at the same time. 0 beyond the record.
std::vector<double> laid_on_track(const std::vector<double>& samples, double sampling_rate_hz, double place_m,
                                  const TrackPath& path);

/// As wheelbase_delays(), along a path of the train: what is left of each delay once the channels are laid on the
/// track, plus distance/mean speed. A channel that is late by a time of its own keeps that time. `series` begins where
/// the path does.
std::vector<PairDelay> laid_delays(const TimeSeries& series, const VehicleGeometry& geometry, const TrackPath& path);

}  // namespace railpem::recordings
