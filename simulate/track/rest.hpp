#pragma once

#include <vector>

#include "simulate/track/track_window.hpp"

namespace railpem::simulate {

/// Static equilibrium of the window's rail under point loads, relative to the unloaded track.
struct Rest {
    std::vector<double> w, theta;       ///< nodes
    std::vector<double> compression_m;  ///< seats: of the pad, from the unloaded state
    std::vector<double> force_n;        ///< seats: on the rail, beyond the unloaded one
    double residual_n = 0.0;            ///< largest unbalanced nodal force
};

/// Newton's method with each seat (pad curve in series with what lies under it) eliminated.
/// `section`: of the rail (the static one may differ); `curve`: pad force against compression, multiplied by `modulus`;
/// `position_m`: places of the loads of `load_n` each, downwards.
/// Throws parameters::ParameterError when no equilibrium is found.
Rest find_rest(const TrackWindow& track, const Section& section, const PadCurve& curve, double modulus,
               const std::vector<double>& position_m, double load_n);

/// Puts the window at rest under the wheels of a vehicle about to move: displacements, pads and what lies under them.
/// Relaxing branches slower than the passage of a vehicle start unstrained, as on track the train has just reached.
void start_moving(TrackWindow& track, const PadCurve& curve, const std::vector<double>& position_m, double load_n);

/// Makes the static equilibrium under the standing vehicle the origin: every pad works about its own compression.
/// `static_curve` and `static_section` carry the statics, the window's own curve the vibration; they meet at equal
/// load.
void start_standing(TrackWindow& track, const RadauStep& step, const Section& static_section,
                    const PadCurve& static_curve, const std::vector<double>& position_m, double load_n);

}  // namespace railpem::simulate
