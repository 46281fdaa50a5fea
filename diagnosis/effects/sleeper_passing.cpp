#include "diagnosis/effects/effect.hpp"

namespace railpem::diagnosis {

EffectInModel sleeper_passing() {
    return {
        .lines_alone = true,
        .retuned = true,
        .needs_time_series = true,
        .apply =
            [](pem::CaseParameters& parameters, const EffectInstance& effect, const ParameterAccess&) {
                double& own = parameters.sleeper_passing.amplitude_factor;
                own = (own == 0.0 ? 1.0 : own) * effect.values.at("amplitude_factor");
            },
    };
}

}  // namespace railpem::diagnosis
