#pragma once
// The pads under a rolling vehicle: what preload makes of their stiffness when the load comes and goes with the wheels.

#include <vector>

#include "track/statics/rolling_pads.hpp"
#include "track/statics/static_equilibrium.hpp"

namespace railpem::track {

/// How far the memory of the pads and the rail's inertia bend the travelling stiffness away from that of a standing
/// load: K0 in N/m over the position in the frame of the wheels. All zero at rest.
struct PassingChange {
    double first_m = 0.0;
    double step_m = 1.0;
    std::vector<double> change_n_per_m;

    /// Cubic between the points, 0 beyond them.
    double at(double position_m) const;
};

/// K0(E(x)) along the history of a pad under `rolling` wheels (pad_history()) less that of the same track with v = 0
/// and g = 1. `track.pads.preload_strength` > 0.
PassingChange passing_change(const TrackParameters& track, const std::vector<double>& wheels_m, double wheel_load_n,
                             const PadHistory& rolling);

/// The pads under the wheels of a vehicle that rolls: equilibrium of the track with E as the pads' curve
/// (passing_track()), `change` added to its dynamic stiffness; exact where all fasteners are sound.
/// `track.pads.preload_strength` > 0. Everything else as static_equilibrium().
StaticEquilibrium moving_equilibrium(const TrackParameters& track, const std::vector<double>& wheels_m,
                                     double wheel_load_n, const std::vector<double>& pads_m,
                                     const PassingChange& change, const StaticEquilibrium* start = nullptr);

}  // namespace railpem::track
