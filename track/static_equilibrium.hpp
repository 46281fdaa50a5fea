#pragma once

#include <string>
#include <vector>

#include "track/track_parameters.hpp"

namespace railpem::track {

/// Every pad under the standing vehicle, in order of position.
struct StaticEquilibrium {
    std::vector<double> position_m;                  ///< from the centre of the car
    std::vector<double> compression_m;               ///< total, clip preload and rail weight included
    std::vector<double> static_stiffness_n_per_m;    ///< dF/dS there
    std::vector<double> dynamic_stiffness_n_per_m;   ///< K0 at the reference frequency, preload strength applied
    double unloaded_compression_m = 0.0;             ///< of a pad far from every wheel
    double unloaded_static_stiffness_n_per_m = 0.0;
    double unloaded_dynamic_stiffness_n_per_m = 0.0;
    int iterations = 0;                              ///< Newton steps taken
    double residual_n = 0.0;                         ///< largest unbalanced nodal force left
    std::vector<std::string> warnings;               ///< lifted pads, loads beyond the measured curve
};

/// Positions of the pads used: seats at multiples of the spacing, phased so that wheel 1 stands wheel_offset_m ahead of one.
/// `count` pads about the centre of the car (modal rail), or for count = 0 as many as reach so far beyond the outermost wheels
/// that the static influence of the wheels has decayed below 1e-10 (exact rail).
std::vector<double> pad_positions(const TrackParameters& track, const std::vector<double>& wheels_m, int count);

/// Static equilibrium of rail, clips, rail weight and wheels on nonlinear pads F(S): Newton with a line search (Wei et al.
/// 2016, section 3). The rail is the Euler (or Timoshenko) beam, exact for the point loads, and goes on uniformly beyond the
/// outermost pads (mid-bay, zero rotation and zero shear), so nothing is lost at the ends.
/// `wheel_load_n`: static load of each wheel. Two-layer supports act in series with the pad.
/// Throws parameters::ParameterError when no equilibrium exists.
StaticEquilibrium static_equilibrium(const TrackParameters& track, const std::vector<double>& wheels_m, double wheel_load_n,
                                     const std::vector<double>& pads_m);

}  // namespace railpem::track
