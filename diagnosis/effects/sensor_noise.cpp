#include "diagnosis/effects/effect.hpp"
#include "diagnosis/effects/sensor_chain_entries.hpp"

namespace railpem::diagnosis {

EffectInModel sensor_noise() {
    return {
        .apply =
            [](pem::CaseParameters& parameters, const EffectInstance& effect, const ParameterAccess&) {
                pem::SensorParameters& sensor = noise_entry(parameters, effect.choices.at("channel"));
                sensor.noise_rms_m_per_s2 = effect.values.at("rms_m_per_s2");
                sensor.noise_slope_db_per_octave = effect.values.at("slope_db_per_octave");
            },
    };
}

}  // namespace railpem::diagnosis
