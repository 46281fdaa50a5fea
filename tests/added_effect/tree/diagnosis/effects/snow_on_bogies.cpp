#include "diagnosis/effects/effect.hpp"

namespace railpem::diagnosis {

EffectInModel snow_on_bogies() {
    return {
        .apply = [](pem::CaseParameters& parameters, const EffectInstance& effect,
                    const ParameterAccess&) { parameters.vehicle.bogie_mass_kg += effect.values.at("snow_kg"); },
    };
}

}  // namespace railpem::diagnosis
