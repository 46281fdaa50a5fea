#include "diagnosis/effects/effect.hpp"
#include "diagnosis/effects/sensor_chain_entries.hpp"

namespace railpem::diagnosis {

EffectInModel timing_skew() {
    return {
        .needs_time_series = true,
        .apply =
            [](pem::CaseParameters& parameters, const EffectInstance& effect, const ParameterAccess&) {
                first_entry(parameters, effect.choices.at("channel")).delay_s += effect.values.at("delay_s");
            },
    };
}

}  // namespace railpem::diagnosis
