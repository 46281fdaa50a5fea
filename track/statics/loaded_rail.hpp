#pragma once
// What the static equilibria are made of: rail, seats and the loads on them.

#include <Eigen/Core>
#include <vector>

#include "track/elements/symmetric_band.hpp"
#include "track/pads/seat_law.hpp"
#include "track/track_parameters.hpp"

namespace railpem::track {

/// The rail on its pads, deflections and loads positive downwards. Nodes: the rear end, the pads, the front end. Wheels
/// need no node of their own. The ends lie mid-bay beyond the outermost pads and do not rotate: the track goes on
/// uniformly.
struct LoadedRail {
    SymmetricBand stiffness;  ///< of the beam
    Eigen::VectorXd load;     ///< rail weight and wheels
    SeatLaw seat;
    std::vector<double> scale;  ///< per pad, what a failed fastener has left
    double largest_load_n = 0.0;

    static int deflection(std::size_t pad) { return static_cast<int>(2 * pad + 1); }
    std::size_t pads() const { return scale.size(); }
};

/// The rail of `track` on pads at `pads_m` (increasing), under its weight and under wheels of `wheel_load_n` each,
/// downwards. Throws parameters::ParameterError when a wheel stands off the track or the curve of the pads is no static
/// law.
LoadedRail loaded_rail(const TrackParameters& track, const std::vector<double>& wheels_m, double wheel_load_n,
                       const std::vector<double>& pads_m);

}  // namespace railpem::track
