#include "pem/coupling/sensor_chain.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "pem/response_names.hpp"

namespace railpem::pem {

namespace {

constexpr double kNoiseFrom = 0.5, kNoiseTo = 500.0, kNoiseReference = 10.0;  // Hz

}  // namespace

std::complex<double> sensor_transfer(const SensorParameters& sensor, double frequency_hz,
                                     const lanes::FactorCurve* correction) {
    std::complex<double> transfer =
        std::polar(1.0, -2.0 * std::numbers::pi * frequency_hz * sensor.delay_s) * sensor.gain;
    if (sensor.resonance_frequency_hz > 0.0) {
        const double x = frequency_hz / sensor.resonance_frequency_hz;
        transfer /= std::complex<double>(1.0 - x * x, 2.0 * sensor.resonance_damping_ratio * x);
    }
    if (correction) transfer *= correction->at(2.0 * std::numbers::pi * frequency_hz);
    return transfer;
}

std::complex<double> channel_transfer(const CaseParameters& parameters, const std::string& response,
                                      double frequency_hz) {
    const std::map<std::string, lanes::FactorCurve>& corrections = parameters.modifiers.sensors;
    std::complex<double> transfer = 1.0;
    std::vector<std::string> corrected;  // a correction counts once, however many sensors a channel has
    for (const SensorParameters& sensor : parameters.sensors) {
        if (measured_response(sensor.channel) != response) continue;
        const auto own = corrections.find(sensor.channel);
        const bool first = std::find(corrected.begin(), corrected.end(), sensor.channel) == corrected.end();
        if (own != corrections.end() && first) corrected.push_back(sensor.channel);
        transfer *= sensor_transfer(sensor, frequency_hz, own != corrections.end() && first ? &own->second : nullptr);
    }
    for (const auto& [channel, correction] : corrections)
        if (measured_response(channel) == response &&
            std::find(corrected.begin(), corrected.end(), channel) == corrected.end())
            transfer *= sensor_transfer({.channel = channel}, frequency_hz, &correction);
    return transfer;
}

double sensor_noise_psd(const SensorParameters& sensor, double frequency_hz) {
    const double power = sensor.noise_slope_db_per_octave / (10.0 * std::log10(2.0));
    const double lower = kNoiseFrom / kNoiseReference, upper = kNoiseTo / kNoiseReference;
    const double integral = std::abs(power + 1.0) < 1e-9
                                ? std::log(upper / lower)
                                : (std::pow(upper, power + 1.0) - std::pow(lower, power + 1.0)) / (power + 1.0);
    const double constant = sensor.noise_rms_m_per_s2 * sensor.noise_rms_m_per_s2 / (kNoiseReference * integral);
    return constant * std::pow(frequency_hz / kNoiseReference, power);
}

void apply_sensors(const CaseParameters& parameters, Solution& solution) {
    const std::size_t lines = solution.frequency_hz.size();
    const std::size_t responses = response_names().size();
    const std::size_t excitations = solution.source_names.size();
    for (const SensorParameters& sensor : parameters.sensors) {
        const std::size_t response = response_index(measured_response(sensor.channel));
        for (std::size_t source = 0; source < excitations; ++source)
            for (std::size_t line = 0; line < lines; ++line)
                solution.pseudo_response[(source * responses + response) * lines + line] *=
                    sensor_transfer(sensor, solution.frequency_hz[line]);
        if (sensor.noise_rms_m_per_s2 == 0.0) continue;
        solution.source_names.push_back("noise_" + sensor.channel);
        solution.pseudo_response.resize(solution.source_names.size() * responses * lines);
        std::complex<double>* noise =
            solution.pseudo_response.data() + ((solution.source_names.size() - 1) * responses + response) * lines;
        for (std::size_t line = 0; line < lines; ++line)
            noise[line] = std::sqrt(sensor_noise_psd(sensor, solution.frequency_hz[line]));
    }
}

}  // namespace railpem::pem
