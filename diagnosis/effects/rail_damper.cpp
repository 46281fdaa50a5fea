#include "diagnosis/effects/effect.hpp"

namespace railpem::diagnosis {

EffectInModel rail_damper() {
    return {
        .approximate = true,  // between rubber and dashpot by a power of the frequency
        .apply =
            [](pem::CaseParameters& parameters, const EffectInstance& effect, const ParameterAccess&) {
                parameters.track.rail_dampers.push_back({.mass_kg_per_m = effect.values.at("mass_kg_per_m"),
                                                         .frequency_hz = effect.values.at("frequency_hz"),
                                                         .loss_factor = effect.values.at("loss_factor"),
                                                         .loss_exponent = effect.values.at("loss_exponent")});
            },
    };
}

}  // namespace railpem::diagnosis
