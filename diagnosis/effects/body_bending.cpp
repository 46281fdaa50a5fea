#include "diagnosis/effects/effect.hpp"

namespace railpem::diagnosis {

EffectInModel body_bending() {
    return {
        .obstacle = [](const pem::CaseParameters& parameters) -> std::optional<Obstacle> {
            if (parameters.vehicle.body_bending.empty()) return std::nullopt;
            return Obstacle{"the body of the case bends already", "a case without [[vehicle.body_bending]]"};
        },
        .apply =
            [](pem::CaseParameters& parameters, const EffectInstance& effect, const ParameterAccess&) {
                parameters.vehicle.body_bending.push_back({.frequency_hz = effect.values.at("frequency_hz"),
                                                           .damping_ratio = effect.values.at("damping_ratio"),
                                                           .modal_mass_kg = effect.values.at("modal_mass_kg"),
                                                           .shape_at_pivots = effect.values.at("shape_at_pivots")});
            },
    };
}

}  // namespace railpem::diagnosis
