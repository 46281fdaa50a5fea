#include "diagnosis/effects/effect.hpp"
#include "diagnosis/effects/sensor_chain_entries.hpp"

namespace railpem::diagnosis {

EffectInModel sensor_gain() {
    return {
        .apply =
            [](pem::CaseParameters& parameters, const EffectInstance& effect, const ParameterAccess&) {
                first_entry(parameters, effect.choices.at("channel")).gain *= effect.values.at("gain");
            },
    };
}

}  // namespace railpem::diagnosis
