#pragma once
// Static equilibria of several trains on one track at once.

#include <vector>

#include "track/statics/static_equilibrium.hpp"

namespace railpem::track {

/// What static_equilibrium() finds for `track` with its regular failures at each of `first_seats`
/// (FailedFasteners::first_seat) in turn; the rest of the table stays. Seats and wheels stand at the same places in all
/// of them, so they are solved side by side, one per lane: Newton's method in the deflection of the rail and the
/// compressions of the pads together, full steps, to the same residual. An equilibrium that it does not find in a few
/// steps (the rail lifts off and settles again) is left to static_equilibrium(). The compressions agree with that
/// function's to 1e-9 of the largest; `iterations`, `residual_n` and `warnings` are filled only where it was called.
/// `start`: similar equilibria to begin from, one per first seat; those with another number of pads are ignored. Throws
/// as static_equilibrium().
std::vector<StaticEquilibrium> equilibria_abreast(const TrackParameters& track, const std::vector<double>& wheels_m,
                                                  double wheel_load_n, const std::vector<double>& pads_m,
                                                  const std::vector<int>& first_seats,
                                                  const std::vector<StaticEquilibrium>& start = {});

}  // namespace railpem::track
