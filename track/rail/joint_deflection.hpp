#pragma once
// What a train of equal forces does to the rail under it: Σ_j R_ij alone, on tracks that differ in their seats only.

#include <optional>
#include <span>
#include <vector>

#include "track/rail/seat_scatter.hpp"
#include "track/statics/seat_row.hpp"

namespace railpem::track {

inline constexpr std::size_t kMostPoints = 4;  ///< on one rail: the wheels of a vehicle

/// Where the points stand in a row of seats.
struct PlacedPoint {
    std::size_t seat = 0;  ///< the one at or behind the point
    double ahead_m = 0.0;  ///< of that seat
};

/// From the rear to the front; nothing when two points share a bay, which joint_deflection() does not know how to do.
/// The seats reach from behind the rearmost point to the foremost one at least (seat_row()).
struct PlacedPoints {
    std::vector<PlacedPoint> points;
    std::vector<std::size_t> order;  ///< points[k] is points_m[order[k]]
};
std::optional<PlacedPoints> place_points(const std::vector<Seat>& seats, const std::vector<double>& points_m,
                                         double spacing_m);

/// Memory of joint_deflection(): what a seat scatters, in two rows side by side.
using ScatterRow = std::vector<std::array<Scatter, 2>>;

/// Deflection at every point under unit forces at all of them, m/N, for each of `rows`: the sums over the rows of
/// RailReceptance::between, at a third of its cost. result[r·points + i] with i as in points_m.
///
/// The track is the uniform one, on which the Bloch waves travel undisturbed, and a seat that differs by ΔK exerts
/// −ΔK·w on it. With the forward waves a over a pad, the backward waves b = q·β, and everything behind the pad as a =
/// S·β + e, a seat makes of S and e, with u = q + S·1 and σ = ΔK/(1 + ΔK·1ᵀu),
///   S − σ·u·uᵀ,  e − σ·u·1ᵀe,  on the way back β + F with F = −σ·(uᵀβ + 1ᵀe),
/// and a bay Λ·S·Λ and Λ·e. Nothing is behind the rearmost seat and in front of the foremost: S, e and β begin at zero.
/// Exact; intact unloaded seats cost next to nothing. `points`: shapes of the placed points, in their order. All rows
/// have their seats at the same places. ΔK below `tolerance`·K0 counts as none.
void joint_deflection(const BlochWaves& waves, const SupportLaw& law, double uniform_pad_stiffness_n_per_m,
                      std::span<const std::vector<Seat>* const> rows, const PlacedPoints& placed,
                      std::span<const BayPoint> points, ScatterRow& memory, lanes::Complex* result,
                      double tolerance = 1e-10);

}  // namespace railpem::track
