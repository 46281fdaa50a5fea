#pragma once

#include <array>
#include <vector>

#include "simulate/track/track_window.hpp"

namespace railpem::simulate {

/// How far the rail gives under a contact within one step: C_ik of both stages' places, at a row of places within a
/// bay. The track repeats itself from bay to bay, so one bay is tabulated. Serves as Jacobian only: what it misses
/// (failed fasteners, nonlinear pads, the neighbouring wheel) is found by the iteration.
struct ContactCompliance {
    double spacing_m = 0.0;
    std::vector<std::array<Complex, 3>> entries;  ///< C11, C12, C22 over one bay, first place repeated at the end

    /// 2×2 real matrix 2·Re(t_i·C_ik·τ_k), row by row, for a wheel at this place at the first stage, m/N.
    std::array<double, 4> at(const RadauStep& step, double position_m) const;
};

/// `advance_m`: distance between the places of the two stages.
ContactCompliance tabulate_compliance(const TrackWindow& track, double advance_m);

}  // namespace railpem::simulate
