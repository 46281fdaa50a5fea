#include "effects/catalogue.hpp"

namespace railpem::effects {

EffectDescription rail_shear() {
    return {
        .id = "rail-shear",
        .row = 40,
        .says =
            "the rail shears, and its section has inertia when it rotates: it is softer between the pads than a beam "
            "that only bends",
        .in_short = "the rail shears and its section rotates",
        .equation =
            "Timoshenko beam: EI ψ'' + κGA(w' − ψ) = −ρIω²ψ, κGA(w'' − ψ') = −mω²w + load; A = m/(7850 kg/m³) "
            "unless the case states a cross-section",
        .source = "Timoshenko 1921, Phil. Mag. 41; Grassie, Gregory, Harrison & Johnson 1982, J. Mech. Eng. Sci. 24",
        .parameters = {{.name = "shear_coefficient",
                        .unit = "1",
                        .low = 0.34,
                        .high = 0.41,
                        .typical = 0.38,
                        .inexact = 0.02,  // scripts/interval_misses.py
                        .simulated = {.standard = 0.4},
                        .in_short = "kappa of the Timoshenko beam",
                        .says = "share κ of the cross-section that carries shear"}},
        .elements = {Element::rail},
        .bands = {{30.0, 500.0}},
        .mimics =
            "A rail with less bending stiffness (parameter-error of track.rail.second_moment_of_area_m4) is as soft "
            "at one frequency; a receptance at mid-bay and over a pad, or the pinned–pinned frequency, separates. "
            "In a running train it shows mostly as a larger sleeper-passing line.",
        .draws = {{.parameters = {{.name = "shear_coefficient", .low = 0.34, .high = 0.41}}}},
    };
}

}  // namespace railpem::effects
