#include "diagnosis/effects/effect.hpp"

namespace railpem::diagnosis {

EffectInModel pad_frequency_stiffening() {
    return {
        .obstacle = [](const pem::CaseParameters& parameters) -> std::optional<Obstacle> {
            if (parameters.track.pads.table_frequency_hz.empty()) return std::nullopt;
            return Obstacle{"the case has a measured pad modulus, which already says how the pad depends on frequency",
                            "a case without track.pads.table_frequency_hz"};
        },
        .apply =
            [](pem::CaseParameters& parameters, const EffectInstance& effect, const ParameterAccess&) {
                track::PadParameters& pads = parameters.track.pads;
                if (pads.exponent == 0.0) pads.causal = true;
                pads.exponent += effect.values.at("exponent");
            },
    };
}

}  // namespace railpem::diagnosis
