#include "diagnosis/effects/effect.hpp"

namespace railpem::diagnosis {

EffectInModel support_compliance() {
    return {
        .looked_for_over_ranges = true,
        .obstacle = [](const pem::CaseParameters& parameters) -> std::optional<Obstacle> {
            if (parameters.track.support.model == track::SupportModel::rigid) return std::nullopt;
            return Obstacle{"the case has a mass and a spring under the pads already",
                            "a case with track.support.model = \"rigid\"; other values of them are a parameter-error"};
        },
        .apply =
            [](pem::CaseParameters& parameters, const EffectInstance& effect, const ParameterAccess&) {
                track::SupportParameters& support = parameters.track.support;
                support.model = track::SupportModel::two_layer;
                support.mass_kg = effect.values.at("mass_kg");
                support.stiffness_n_per_m = effect.values.at("stiffness_n_per_m");
                support.damping_n_s_per_m = effect.values.at("damping_n_s_per_m");
                support.loss_factor = 0.0;
            },
    };
}

}  // namespace railpem::diagnosis
