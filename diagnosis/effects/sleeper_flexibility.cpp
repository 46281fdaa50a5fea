#include "diagnosis/effects/effect.hpp"

namespace railpem::diagnosis {

EffectInModel sleeper_flexibility() {
    return {
        .obstacle = [](const pem::CaseParameters& parameters) -> std::optional<Obstacle> {
            if (parameters.track.support.model == track::SupportModel::two_layer) return std::nullopt;
            return Obstacle{"there is no sleeper in the case that could bend",
                            "a case with track.support.model = \"two-layer\", or support-compliance beside it"};
        },
        .apply =
            [](pem::CaseParameters& parameters, const EffectInstance& effect, const ParameterAccess&) {
                parameters.track.support.bending_modes.push_back({.frequency_hz = effect.values.at("frequency_hz"),
                                                                  .loss_factor = effect.values.at("loss_factor"),
                                                                  .modal_mass_kg = effect.values.at("modal_mass_kg")});
            },
    };
}

}  // namespace railpem::diagnosis
