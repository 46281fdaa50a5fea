#include "diagnosis/effects/effect.hpp"
#include "diagnosis/effects/sensor_chain_entries.hpp"

namespace railpem::diagnosis {

EffectInModel sensor_resonance() {
    return {
        .apply =
            [](pem::CaseParameters& parameters, const EffectInstance& effect, const ParameterAccess&) {
                const std::string& channel = effect.choices.at("channel");
                pem::SensorParameters* sensor = &first_entry(parameters, channel);
                if (sensor->resonance_frequency_hz > 0.0) sensor = &entry_before(parameters, channel);
                sensor->resonance_frequency_hz = effect.values.at("frequency_hz");
                sensor->resonance_damping_ratio = effect.values.at("damping_ratio");
            },
    };
}

}  // namespace railpem::diagnosis
