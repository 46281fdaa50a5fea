#include "diagnosis/effects/effect.hpp"

namespace railpem::diagnosis {

EffectInModel pad_preload_stiffening() {
    return {
        .approximate = true,  // the tangent at the load of the wheels; vibration itself bends the curve
        .follows_load = true,
        .needs_train = true,
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
