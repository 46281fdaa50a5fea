#include "simulate/effects/sensor_of.hpp"

namespace railpem::simulate {

pem::SensorParameters& sensor_of(HiddenTarget target, const HiddenValues& values) {
    const std::string& channel = values.texts.at("channel");
    for (pem::SensorParameters& sensor : target.parameters.sensors)
        if (sensor.channel == channel) return sensor;
    target.parameters.sensors.push_back({.channel = channel});
    return target.parameters.sensors.back();
}

}  // namespace railpem::simulate
