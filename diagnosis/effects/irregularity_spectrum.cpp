#include "diagnosis/effects/effect.hpp"

namespace railpem::diagnosis {

EffectInModel irregularity_spectrum() {
    return {
        .retuned = true,
        .apply =
            [](pem::CaseParameters& parameters, const EffectInstance& effect, const ParameterAccess&) {
                parameters.irregularity.level_db += effect.values.at("level_db");
                parameters.irregularity.slope_db_per_octave += effect.values.at("slope_db_per_octave");
            },
    };
}

}  // namespace railpem::diagnosis
