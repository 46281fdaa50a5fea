#pragma once

#include <string>
#include <vector>

#include "track/pads/pad_positions.hpp"
#include "track/track_parameters.hpp"

namespace railpem::track {

/// Every pad under the standing vehicle, in order of position. The stiffnesses are those of a sound pad so compressed.
struct StaticEquilibrium {
    std::vector<double> position_m;                 ///< from the centre of the car
    std::vector<double> compression_m;              ///< total, clip preload and rail weight included
    std::vector<double> static_stiffness_n_per_m;   ///< dF/dS there
    std::vector<double> dynamic_stiffness_n_per_m;  ///< K0 at the reference frequency, preload strength applied
    std::vector<double>
        remaining_fraction;  ///< 1; at a failed fastener what is left of both stiffnesses and of the dashpot
    double unloaded_compression_m = 0.0;  ///< of an intact pad far from every wheel
    double unloaded_static_stiffness_n_per_m = 0.0;
    double unloaded_dynamic_stiffness_n_per_m = 0.0;
    std::vector<double> deflection;     ///< of the rail at all nodes, m and rad: where another equilibrium may start
    int iterations = 0;                 ///< Newton steps taken
    double residual_n = 0.0;            ///< largest unbalanced nodal force left
    std::vector<std::string> warnings;  ///< lifted pads, loads beyond the measured curve
};

/// Static equilibrium of rail, clips, rail weight and wheels on nonlinear pads F(S): Newton with a line search (Wei et
/// al. 2016, section 3). The rail is the Euler or Timoshenko beam, solved exactly for point loads and its own weight,
/// and goes on uniformly beyond the outermost pads (mid-bay, zero rotation and zero shear), so nothing is lost at the
/// ends. A pad that the rail leaves carries nothing; clips are soft and press with their preload whatever the
/// compression; supports of the two-layer model act in series with the pad and hold both ways; a failed fastener keeps
/// its share of pad and clip. `pads_m`: positions from pad_positions(). `wheel_load_n`: static load of each wheel,
/// downwards. `track` must have passed check(). Accuracy: the residual is below 1e-10 of the largest load; against an
/// independent solution the compressions agree to 1e-8. Throws parameters::ParameterError when a wheel stands off the
/// track or no equilibrium exists. `start`: a similar equilibrium (wheels shifted by part of a bay, other fasteners
/// failed) to begin from; it saves iterations and changes nothing but rounding; one with another number of pads is
/// ignored.
StaticEquilibrium static_equilibrium(const TrackParameters& track, const std::vector<double>& wheels_m,
                                     double wheel_load_n, const std::vector<double>& pads_m,
                                     const StaticEquilibrium* start = nullptr);

/// What the dynamics need of the equilibrium while the stiffness of the pads does not depend on their load
/// (preload_strength 0): positions and dynamic stiffnesses alone, everything else empty or zero.
StaticEquilibrium load_independent_pads(const TrackParameters& track, const std::vector<double>& pads_m);

}  // namespace railpem::track
