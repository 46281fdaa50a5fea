#include "simulate/effects/hidden_effects.hpp"
#include "simulate/effects/sensor_of.hpp"

namespace railpem::simulate {

void hide_sensor_noise(const HiddenValues& values, HiddenTarget target) {
    pem::SensorParameters& sensor = sensor_of(target, values);
    sensor.noise_rms_m_per_s2 = values.numbers.at("rms_m_per_s2");
    sensor.noise_slope_db_per_octave = values.numbers.at("slope_db_per_octave");
}

}  // namespace railpem::simulate
