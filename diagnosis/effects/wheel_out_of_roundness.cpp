#include "diagnosis/effects/effect.hpp"

namespace railpem::diagnosis {

EffectInModel wheel_out_of_roundness() {
    return {
        .excites = true,
        .lines_alone = true,
        .needs_lines = true,
        .apply =
            [](pem::CaseParameters& parameters, const EffectInstance& effect, const ParameterAccess&) {
                parameters.wheel_out_of_roundness.push_back({.wheel = std::stoi(effect.choices.at("wheel")),
                                                             .order = std::stoi(effect.choices.at("order")),
                                                             .amplitude_m = effect.values.at("amplitude_m")});
            },
    };
}

}  // namespace railpem::diagnosis
