#pragma once
// Receptances of a track whose seats differ, from the Bloch waves of the uniform track that they scatter.

#include <array>
#include <optional>
#include <vector>

#include "track/rail/exact_rail.hpp"
#include "track/rail/joint_deflection.hpp"
#include "track/rail/seat_scatter.hpp"

namespace railpem::track {

/// The finite part of an ExactRail as a row of seats, and points in bays.
struct ScatteredRail {
    struct Seat {
        double pad_stiffness_n_per_m = 0.0;  ///< K0 of the sound pad
        double scale = 1.0;                  ///< what a failed fastener has left
        bool differs = false;                ///< from the uniform seats
    };
    std::vector<Seat> seats;
    PlacedPoints placed;
};

/// Nothing when all seats are alike, or where scattered_receptance() does not know how to place the points: two in a
/// bay, more than four. `tolerance`: K0 that differs by less, relative, counts as none.
std::optional<ScatteredRail> scattered_rail(const ExactRail& rail, double tolerance = 1e-10);

/// Memory of scattered_receptance().
struct ScatteredWorkspace {
    std::vector<WavePair> strength;  ///< per seat, towards the rear
};

/// The same as rail_receptance() at a third of its cost, where apart(waves). `law` and `waves` are those of the rail at
/// ω; `result` has the size that ExactRailWorkspace gives it. False, and nothing written, where the waves leave too few
/// digits.
///
/// Seats are crossed as in joint_deflection(), from the rear and, mirrored, from the front at once: what is behind a
/// bay answers with a = S·β + e, what is ahead of it with b = q·β = Q·α + f, a = q·α. A unit force at a point between
/// them, shapes φ and φ̄, leaves
///   β = Λq⁻¹·(Q·α + f) + φ,  α = Λq⁻¹·(S·β + e) + φ̄,  w = own + φᵀ(S·β + e) + φ̄ᵀ(Q·α + f).
/// Its β travels on to the points behind. The sum of all pad forces under a unit force is, by reciprocity, the
/// deflection there when every seat is loaded with its own stiffness K + ΔK: the uniform track is so by `settled`, and
/// a seat that differs adds ΔK·(1 − w). Only that needs e and f.
bool scattered_receptance(const ScatteredRail& rail, const BlochWaves& waves, const SupportLaw& law,
                          double uniform_pad_stiffness_n_per_m, ScatteredWorkspace& workspace, RailReceptance& result);

}  // namespace railpem::track
