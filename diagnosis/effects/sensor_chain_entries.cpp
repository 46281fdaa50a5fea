#include "diagnosis/effects/sensor_chain_entries.hpp"

#include <algorithm>

namespace railpem::diagnosis {

namespace {

std::vector<pem::SensorParameters>::iterator find_first(pem::CaseParameters& parameters, const std::string& channel) {
    return std::find_if(parameters.sensors.begin(), parameters.sensors.end(),
                        [&](const pem::SensorParameters& sensor) { return sensor.channel == channel; });
}

}  // namespace

pem::SensorParameters& first_entry(pem::CaseParameters& parameters, const std::string& channel) {
    const auto found = find_first(parameters, channel);
    if (found != parameters.sensors.end()) return *found;
    return parameters.sensors.emplace_back(pem::SensorParameters{.channel = channel});
}

pem::SensorParameters& entry_before(pem::CaseParameters& parameters, const std::string& channel) {
    return *parameters.sensors.insert(find_first(parameters, channel), pem::SensorParameters{.channel = channel});
}

pem::SensorParameters& noise_entry(pem::CaseParameters& parameters, const std::string& channel) {
    for (auto sensor = parameters.sensors.rbegin(); sensor != parameters.sensors.rend(); ++sensor) {
        if (sensor->channel != channel) continue;
        if (sensor->noise_rms_m_per_s2 == 0.0) return *sensor;
        break;
    }
    return parameters.sensors.emplace_back(pem::SensorParameters{.channel = channel});
}

}  // namespace railpem::diagnosis
