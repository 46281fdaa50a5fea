#include "simulate/effects/hidden_effects.hpp"
#include "simulate/effects/sensor_of.hpp"

namespace railpem::simulate {

void hide_sensor_resonance(const HiddenValues& values, HiddenTarget target) {
    pem::SensorParameters& sensor = sensor_of(target, values);
    sensor.resonance_frequency_hz = values.numbers.at("frequency_hz");
    sensor.resonance_damping_ratio = values.numbers.at("damping_ratio");
}

}  // namespace railpem::simulate
