#include "diagnosis/effects/catalogue.hpp"

namespace railpem::diagnosis {

Effect pad_preload_stiffening() {
    return {
        .id = "pad-preload-stiffening",
        .says = "the pads under the wheels are stiffer than the others because the weight of the train presses on them",
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
                        .says = "the share s: 1 is what the static curve of the pad gives"}},
        .elements = {Element::pad},
        .bands = {{30.0, 200.0}},
        .mimics =
            "Stiffer pads everywhere (parameter-error of the pad): at one load only the coupling of neighbouring "
            "wheels by the softer pads between them differs. A second load, empty and full, separates: preload "
            "stiffening follows the load, nothing else does.",
        .approximate = true,  // the tangent at the load of the wheels; vibration itself bends the curve
        .follows_load = true,
        .obstacle = [](const pem::CaseParameters& parameters) -> std::optional<Obstacle> {
            const track::PadParameters& pads = parameters.track.pads;
            if (!pads.force_polynomial_n.empty() || !pads.curve_force_n.empty()) return std::nullopt;
            return Obstacle{"the case has no static curve of the pad, so the load does not stiffen it",
                            "a case with track.pads.force_polynomial_n or track.pads.curve_force_n"};
        },
        .apply = [](pem::CaseParameters& parameters, const EffectInstance& effect,
                    const ParameterAccess&) { parameters.track.pads.preload_strength += effect.values.at("strength"); },
    };
}

}  // namespace railpem::diagnosis
