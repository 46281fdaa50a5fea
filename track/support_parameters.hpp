#pragma once

#include <vector>

#include "parameters/field.hpp"

namespace railpem::track {

enum class SupportModel { rigid, two_layer };

/// A bending mode of the sleeper, seen at the rail seat (unit displacement there).
/// Rests on the same ballast as the rigid sleeper: a uniform beam on a uniform foundation keeps its free modes, so the
/// foundation adds (ballast stiffness)·(modal mass)/(sleeper mass) to the modal stiffness.
struct SleeperMode {
    double frequency_hz = 120.0;  ///< free–free
    double loss_factor = 0.02;
    double modal_mass_kg = 80.0;  ///< per rail seat, for unit displacement at the seat
};

/// What carries the pads, per rail seat: rigid ground, or a mass (sleeper, slab) on a spring (ballast, mat).
/// Receptance below the pad: 1/(k(1 + iη) + iωc − ω²M) + Σ_n 1/(m_n[ω_n²(1 + iη_n) − ω²] + (k(1 + iη) + iωc)·m_n/M).
struct SupportParameters {
    SupportModel model = SupportModel::rigid;
    double mass_kg = 0.0;
    double stiffness_n_per_m = 0.0;
    double damping_n_s_per_m = 0.0;
    double loss_factor = 0.0;
    std::vector<SleeperMode> bending_modes;
};

parameters::Fields<SupportParameters> support_fields();
parameters::Fields<SleeperMode> sleeper_mode_fields();

}  // namespace railpem::track
