#include "diagnosis/effects/damper_series_stiffness.hpp"

namespace railpem::diagnosis {

EffectInModel damper_series_stiffness(vehicle::SuspensionParameters vehicle::VehicleParameters::*stage) {
    return {
        .apply =
            [stage](pem::CaseParameters& parameters, const EffectInstance& effect, const ParameterAccess&) {
                double& series = (parameters.vehicle.*stage).damper_series_stiffness_n_per_m;
                series = 1.0 / (1.0 / series + 1.0 / effect.values.at("stiffness_n_per_m"));
            },
    };
}

}  // namespace railpem::diagnosis
