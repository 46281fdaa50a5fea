#pragma once

#include <vector>

#include "parameters/field.hpp"

namespace railpem::track {

enum class Beam { euler, timoshenko };

/// One rail. The Euler beam uses E, I and m; the Timoshenko beam also G, κ, A and the rotary inertia ρI = m·I/A.
struct RailParameters {
    Beam beam = Beam::euler;
    double youngs_modulus_pa = 0.0;
    double second_moment_of_area_m4 = 0.0;
    double mass_kg_per_m = 0.0;
    double loss_factor = 0.0;        ///< η of E and G: E(1 + iη), G(1 + iη)
    double loss_reference_hz = 0.0;  ///< η holds there and grows in proportion to the frequency; 0: constant
    double shear_modulus_pa = 81e9;
    double shear_coefficient = 0.4;    ///< κ (effective shear area κA)
    double cross_section_m2 = 7.7e-3;  ///< A
};

/// A continuous line of tuned masses on the rail. Per metre of rail the dampers add the dynamic mass
/// m_d·ω_d²(1 + iη)/(ω_d²(1 + iη) − ω²) (Thompson, Jones, Waters & Farrington 2007, Applied Acoustics 68), with the
/// loss factor η = loss_factor·(ω/ω_d)^loss_exponent: rubber has nearly the same at all frequencies, a dashpot one in
/// proportion to the frequency.
struct RailDamper {
    double mass_kg_per_m = 10.0;
    double frequency_hz = 500.0;
    double loss_factor = 0.35;   ///< at its own frequency
    double loss_exponent = 0.0;  ///< 0: rubber, 1: dashpot
};

parameters::Fields<RailParameters> rail_fields();
parameters::Fields<RailDamper> rail_damper_fields();

}  // namespace railpem::track
