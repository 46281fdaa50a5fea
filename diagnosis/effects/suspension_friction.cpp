#include "diagnosis/effects/effect.hpp"

namespace railpem::diagnosis {

EffectInModel suspension_friction() {
    return {
        .approximate = true,
        .follows_level = true,
        .apply =
            [](pem::CaseParameters& parameters, const EffectInstance& effect, const ParameterAccess&) {
                vehicle::VehicleParameters& car = parameters.vehicle;
                (effect.choices.at("stage") == "primary" ? car.primary : car.secondary).friction_force_n +=
                    effect.values.at("force_n");
            },
    };
}

}  // namespace railpem::diagnosis
