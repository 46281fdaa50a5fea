#include <limits>

#include "diagnosis/effects/catalogue.hpp"
#include "diagnosis/effects/choices.hpp"
#include "diagnosis/effects/sensor_chain_entries.hpp"

namespace railpem::diagnosis {

Effect sensor_resonance() {
    return {
        .id = "sensor-resonance",
        .says = "the mounting of a sensor resonates and raises what it reads near that frequency",
        .equation = "channel × 1/(1 − (f/f_m)² + 2iζf/f_m): one row and one column of the cross-spectral matrix",
        .source = "ISO 5348 (mechanical mounting of accelerometers)",
        .parameters = {{.name = "frequency_hz",
                        .unit = "Hz",
                        .low = 40.0,
                        .high = 2000.0,
                        .typical = 250.0,
                        .spread = Spread::logarithmic,
                        .strength = true,
                        .nothing = std::numeric_limits<double>::infinity(),
                        .says = "frequency of the sensor on its mounting"},
                       {.name = "damping_ratio",
                        .unit = "1",
                        .low = 0.005,
                        .high = 0.5,
                        .typical = 0.05,
                        .spread = Spread::logarithmic,
                        .says = "its damping ratio"}},
        .choices = {{.name = "channel", .options = channel_names(), .says = "the channel"}},
        .elements = {Element::sensor},
        .bands = {{40.0, 500.0}},
        .mimics =
            "A mode of the part that carries the sensor; that one moves its neighbours as well. Well below its "
            "frequency it is a gain that grows with f².",
        .obstacle = {},
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
