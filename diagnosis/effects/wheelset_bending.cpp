#include "diagnosis/effects/effect.hpp"

namespace railpem::diagnosis {

EffectInModel wheelset_bending() {
    return {
        .obstacle = [](const pem::CaseParameters& parameters) -> std::optional<Obstacle> {
            if (parameters.vehicle.wheelset_bending.empty()) return std::nullopt;
            return Obstacle{"the wheelsets of the case bend already", "a case without [[vehicle.wheelset_bending]]"};
        },
        .apply =
            [](pem::CaseParameters& parameters, const EffectInstance& effect, const ParameterAccess&) {
                parameters.vehicle.wheelset_bending.push_back({.frequency_hz = effect.values.at("frequency_hz"),
                                                               .damping_ratio = effect.values.at("damping_ratio"),
                                                               .modal_mass_kg = effect.values.at("modal_mass_kg")});
            },
    };
}

}  // namespace railpem::diagnosis
