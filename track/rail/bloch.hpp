#pragma once
// Waves of the uniform, infinite, periodically supported rail.

#include <functional>
#include <utility>

#include "track/elements/rail_element.hpp"

namespace railpem::track {

/// Half of the infinite uniform track, seen from a node with a support.
struct HalfTrack {
    /// Dynamic stiffness of everything beyond the node towards increasing x; the node's own support is not in it.
    /// Towards decreasing x it is mirrored(stiffness).
    lanes::Matrix2 stiffness;
    /// d_{n+1} = advance·d_n from support to support in the decaying waves.
    lanes::Matrix2 advance;
    /// The two factors per bay, |λ| ≤ 1; the one nearer to 1 is the wave that reaches far.
    lanes::Complex factor_1, factor_2;
};

/// `bay`: the rail between two supports; `support`: complex stiffness of every support.
///
/// det(farᵀ/λ + M + far·λ) = 0 with M = near + mirrored(near) + support is a quadratic in C = (λ + 1/λ)/2; of each pair
/// λ, 1/λ the decaying one is taken. The matrix that advances by a bay follows from sum and product of the two factors
/// alone (Cayley–Hamilton), so nothing breaks where they coincide. `lossy` gives bay and support of the same track with
/// a little more loss; it is asked only where |λ| = 1 (no damping), to tell which wave travels outwards (limiting
/// absorption).
using Bay = std::pair<RailElement, lanes::Complex>;
HalfTrack half_track(const RailElement& bay, const lanes::Complex& support, const std::function<Bay()>& lossy);

}  // namespace railpem::track
