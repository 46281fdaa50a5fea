#pragma once
// Where a train is at a time, from its speed.

#include <cstddef>
#include <vector>

namespace railpem::recordings {

/// A path along the track: the speed is linear between the times i·step_s, and as at the ends beyond them.
struct TrackPath {
    double step_s = 1.0;
    std::vector<double> speed_m_per_s;  ///< at i·step_s, all positive
    std::vector<double> distance_m;     ///< there; 0 at time 0

    double mean_m_per_s() const;  ///< over the time that it is known
    double speed_at(double time_s) const;
    double distance_at(double time_s) const;
    /// The inverse of distance_at(), s.
    double time_at(double distance_m) const;
};

/// The path of speeds known at increasing times, linear between them and constant beyond, every `step_s` until `end_s`.
TrackPath track_path(const std::vector<double>& time_s, const std::vector<double>& speed_m_per_s, double step_s,
                     double end_s);

}  // namespace railpem::recordings
