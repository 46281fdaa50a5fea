#include "diagnosis/effects/effect.hpp"

namespace railpem::diagnosis {

EffectInModel bogie_mounted_mass() {
    return {
        .apply =
            [](pem::CaseParameters& parameters, const EffectInstance& effect, const ParameterAccess&) {
                // A mass of nothing would be a degree of freedom with neither inertia nor stiffness.
                if (effect.values.at("mass_kg") == 0.0) return;
                parameters.vehicle.bogie_mounted_masses.push_back({.mass_kg = effect.values.at("mass_kg"),
                                                                   .frequency_hz = effect.values.at("frequency_hz"),
                                                                   .damping_ratio = effect.values.at("damping_ratio")});
            },
    };
}

}  // namespace railpem::diagnosis
