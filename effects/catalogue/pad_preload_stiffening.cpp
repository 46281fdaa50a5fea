#include "effects/catalogue.hpp"

namespace railpem::effects {

EffectDescription pad_preload_stiffening() {
    return {
        .id = "pad-preload-stiffening",
        .row = 20,
        .says = "the pads under the wheels are stiffer than the others because the weight of the train presses on them",
        .in_short = "the pads under the wheels are stiffer because of the load on them",
        .equation =
            "K0_j = ratio·[(1 − s)·K_secant + s·K(S_j)], S_j from the nonlinear static equilibrium of rail, clips "
            "and wheels; s adds to the case's own",
        .source = "Wei et al. 2016, Shock and Vibration, eqs. (2), (3), (11)",
        .parameters = {{.name = "strength",
                        .unit = "1",
                        .low = 0.2,
                        .high = 1.5,
                        .typical = 1.0,
                        .strength = true,
                        .nothing = 0.0,
                        .inexact = 0.04,  // docs/theory/diagnosis.md
                        .in_short = "share of the preload law",
                        .says = "the share s: 1 is what the static curve of the pad gives"}},
        .elements = {Element::pad},
        .bands = {{30.0, 200.0}},
        .mimics =
            "Stiffer pads everywhere (parameter-error of the pad): at one load only the coupling of neighbouring "
            "wheels by the softer pads between them differs. A second load, empty and full, separates: preload "
            "stiffening follows the load, nothing else does.",
        .draws = {{.parameters = {{.name = "strength", .low = 0.2, .high = 1.5}}, .strength = "strength"}},
    };
}

}  // namespace railpem::effects
