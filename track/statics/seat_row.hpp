#pragma once
// The seats that a finite part of the rail may need as nodes.

#include <vector>

#include "track/statics/static_equilibrium.hpp"

namespace railpem::track {

/// Two positions closer than this, m, are one; far below any length that matters, far above rounding of positions.
inline constexpr double kSameNode = 1e-9;

struct Seat {
    double position_m = 0.0;
    double pad_stiffness_n_per_m = 0.0;  ///< K0 of the sound pad
    double scale = 1.0;                  ///< what a failed fastener has left
};

/// All seats of the equilibrium, from the rear to the front, and as many unloaded ones beyond them as it takes to have
/// points_m between seats.
std::vector<Seat> seat_row(const TrackParameters& track, const std::vector<double>& points_m,
                           const StaticEquilibrium& equilibrium);

}  // namespace railpem::track
