#pragma once
// The speed of a train as a function of time, from the delays with which its wheels meet the same track.

#include <optional>
#include <vector>

#include "recordings/estimates/track_path.hpp"
#include "recordings/estimates/wheelbase_speed.hpp"
#include "recordings/recording.hpp"

namespace railpem::recordings {

/// The path of a record, and how well it is known.
struct RunningSpeed {
    TrackPath path;
    double relative_error = 0.0;  ///< standard deviation of the speed of one window by chance
    /// share of the weighted phases that it explains, mean over windows: 1 without noise and coupling
    double agreement = 0.0;
    std::size_t pairs = 0;  ///< of channels that it was read from
};

/// How it is read. Windows are long enough for a phase to be known, and short beside the seconds in which a train
/// changes its speed.
struct RunningSpeedOptions {
    double window_s = 4.0;
    double hop_s = 0.5;
    double first_window_s = 1.5;  ///< of the first look, in which a train that speeds up must not change its delays
    double from_hz = 5.0;         ///< below, body and bogies move as one and carry no delay
    double to_hz = 90.0;          ///< above, wheels of one bogie hear each other through the rail
    double search = 0.5;          ///< relative range about the expected speed in which the first look searches
    /// m/s², the most that a train speeds up or brakes: neighbouring windows differ by no more
    double most_acceleration = 1.0;
    int refinements = 8;  ///< each aligns the channels by the path found so far, and reads what is left
};

/// From pairs of axle boxes, or of bogies, that stand at least half of the longest distance apart. First each window's
/// whitened cross-correlation and the most probable path through all windows (Viterbi 1967); then, channels laid on the
/// track by that path, the phase slope that is left, weighted by coherence as in estimate_delay(). In the track's
/// coordinate two wheels meet the same wave at any speed, so that a change of speed within a window costs no
/// coherence. Nothing when there is no such pair, or the record is shorter than four windows. The mean speed is as good
/// as wheelbase_speed()'s; changes about it are good to a few parts in 1e5 where axle boxes are quiet.
std::optional<RunningSpeed> running_speed(const TimeSeries& series, const VehicleGeometry& geometry,
                                          double expected_m_per_s, const RunningSpeedOptions& options = {});

}  // namespace railpem::recordings
