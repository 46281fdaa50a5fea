#pragma once
// What a diagnosis lets a track differ by from its parameters: complex factors over frequency, 1 when empty.

#include "lanes/factor_curve.hpp"

namespace railpem::track {

struct TrackModifiers {
    lanes::FactorCurve rail;     ///< on the dynamic mass of rail and dampers, not on the rotary inertia
    lanes::FactorCurve pads;     ///< on K_j(f), dashpot included
    lanes::FactorCurve support;  ///< on k(1 + iη) + iωc, wherever it stands; without effect on rigid ground
};

}  // namespace railpem::track
