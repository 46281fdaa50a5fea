#include "diagnosis/observations/channel_scales.hpp"

#include <algorithm>
#include <cmath>

namespace railpem::diagnosis {

void scale_channels(const std::vector<double>& log_gain, std::vector<std::complex<double>>& values) {
    const std::size_t size = log_gain.size();
    if (std::all_of(log_gain.begin(), log_gain.end(), [](double gain) { return gain == 0.0; })) return;
    std::vector<double> amplitude(size);
    for (std::size_t c = 0; c < size; ++c) amplitude[c] = std::exp(0.5 * log_gain[c]);
    for (std::size_t at = 0; at < values.size(); ++at) values[at] *= amplitude[at % size] * amplitude[at / size % size];
}

void guess_scales(Observation& observation, const pem::CaseParameters& believed) {
    const std::size_t size = observation.channels.size(), bins = observation.bins();
    observation.log_scale.assign(size, 0.0);
    if (std::none_of(observation.unknown_scale.begin(), observation.unknown_scale.end(),
                     [](bool unknown) { return unknown; }))
        return;
    pem::CaseParameters parameters = believed;
    parameters.vehicle.payload_kg = observation.payload_kg;
    parameters.frequency.to_hz = observation.expectation.high_hz;
    const ExpectedSpectra expected = expected_spectra(parameters, observation.speed_m_per_s, observation.kernel,
                                                      observation.channels, {}, observation.expectation);
    for (std::size_t c = 0; c < size; ++c) {
        if (!observation.unknown_scale[c]) continue;
        double sum = 0.0, count = 0.0;
        for (std::size_t bin = 0; bin < bins; ++bin) {
            const std::size_t at = bin * size * size + c * (size + 1);
            const double recorded = observation.fitted.values[at].real(), own = expected.values[at].real();
            if (!(recorded > 0.0 && own > 0.0)) continue;
            sum += std::log(recorded / own);
            count += 1.0;
        }
        if (count > 0.0) observation.log_scale[c] = sum / count;
    }
}

}  // namespace railpem::diagnosis
