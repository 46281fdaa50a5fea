#include "diagnosis/observations/held_distortion.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "pem/distortion/contact_distortion.hpp"
#include "pem/response_names.hpp"

namespace railpem::diagnosis {

namespace {

bool is_wheel(const Observation& observation, std::size_t channel) {
    const std::string& where = pem::response_names()[observation.channels[channel].response].where;
    return where.starts_with("wheel") && !observation.unknown_scale[channel];
}

/// Power of the wheels per bin.
std::vector<double> power_of(const Observation& observation, const std::vector<std::complex<double>>& values) {
    const std::size_t size = observation.channels.size();
    std::vector<double> power(observation.bins(), 0.0);
    for (std::size_t bin = 0; bin < power.size(); ++bin)
        for (std::size_t c = 0; c < size; ++c)
            if (is_wheel(observation, c)) power[bin] += values[bin * size * size + c * (size + 1)].real();
    return power;
}

/// Recorded by believed, in thirds of an octave about every bin.
std::vector<double> ratio_of(const std::vector<double>& recorded, const std::vector<double>& believed,
                             std::size_t first_bin) {
    const double side = kObservationSettings.comparison_side;
    std::vector<double> ratio;
    for (std::size_t bin = 0; bin < recorded.size(); ++bin) {
        double own = 0.0, other = 0.0;
        const double at = static_cast<double>(first_bin + bin);
        for (std::size_t i = 0; i < recorded.size(); ++i) {
            const double beside = static_cast<double>(first_bin + i);
            if (beside < at / side || beside > at * side) continue;
            own += recorded[i];
            other += believed[i];
        }
        ratio.push_back(other > 0.0 ? own / other : 1.0);
    }
    return ratio;
}

}  // namespace

void hold_contact_distortion(Observation& observation, const pem::CaseParameters& believed) {
    pem::CaseParameters parameters = believed;
    parameters.vehicle.payload_kg = observation.payload_kg;
    parameters.solver.moving = true;
    parameters.frequency.to_hz = observation.expectation.high_hz;
    observation.expectation.contacts = {};
    const ExpectedSpectra expected = expected_spectra(parameters, observation.speed_m_per_s, observation.kernel,
                                                      observation.channels, {}, observation.expectation);
    const std::vector<double> ratio = ratio_of(power_of(observation, observation.all.values),
                                               power_of(observation, expected.values), observation.first_bin());
    const double bin_hz = observation.kernel.bin_hz();
    const auto first = static_cast<long>(observation.first_bin());
    const auto at = [&](double frequency) {
        const long bin = std::clamp(std::lround(frequency / bin_hz) - first, 0L, static_cast<long>(ratio.size()) - 1);
        return ratio[static_cast<std::size_t>(bin)];
    };
    observation.expectation.contacts = pem::contact_distortion(parameters, observation.speed_m_per_s, at);
}

}  // namespace railpem::diagnosis
