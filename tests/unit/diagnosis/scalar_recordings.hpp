#pragma once
// Recordings of the track and spectra made from a case by `pem` itself, and the believed case of the tests.

#include <cmath>
#include <random>

#include "app/schema/believed_case.hpp"
#include "app/schema/case_file.hpp"
#include "diagnosis/diagnose.hpp"
#include "diagnosis/observations/observe_scalars.hpp"
#include "pem/coupling/solution.hpp"
#include "pem/coupling/solve_case.hpp"
#include "pem/coupling/track_response.hpp"
#include "pem/response_names.hpp"
#include "spectra/third_octaves.hpp"

namespace railpem::diagnosis {

inline BelievedCase believed_file(const std::string& path) {
    return app::believed_case(app::read_case(std::string(RAILPEM_SOURCE_DIR) + "/" + path, {}));
}

/// Decay rates in third-octaves from 100 to 4000 Hz, each off by a factor of 1 ± `error` (Gaussian in the logarithm).
inline recordings::Recording decay_recording(const pem::CaseParameters& truth, double error, unsigned seed) {
    const pem::TrackResponse response = pem::track_response(truth, pem::geometric_lines(80.0, 5000.0, 1500), true, 2);
    recordings::Recording recording;
    recording.description.kind = recordings::RecordingKind::decay_rate;
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal(0.0, error);
    for (const spectra::ThirdOctaveBand& band : spectra::third_octave_bands(89.0, 4500.0))
        for (const pem::DecayBand& decay : pem::decay_bands(response, {band.centre_hz}, truth.track.spacing_m)) {
            recording.decay_rate.centre_hz.push_back(band.nominal_hz);
            recording.decay_rate.decay_rate_db_per_m.push_back(decay.decay_rate_db_per_m * std::exp(normal(random)));
            recording.decay_rate.standard_error_db_per_m.push_back(decay.decay_rate_db_per_m * error);
        }
    return recording;
}

/// Receptance over a support from 30 to 2000 Hz with independent errors of real and imaginary part.
inline recordings::Recording receptance_recording(const pem::CaseParameters& truth, double error, unsigned seed) {
    recordings::Recording recording;
    recording.description.kind = recordings::RecordingKind::receptance;
    recording.receptance.frequency_hz = pem::geometric_lines(30.0, 2000.0, 150);
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal(0.0, error);
    for (const std::complex<double> value :
         pem::track_response(truth, recording.receptance.frequency_hz, false, 2).over_pad)
        recording.receptance.value_m_per_n.push_back(value *
                                                     std::exp(std::complex<double>(normal(random), normal(random))));
    return recording;
}

/// PSDs of wheel 1, bogie 1 and the body centre at 80 km/h, as a mean of n independent averages would scatter.
inline recordings::Recording psd_recording(pem::CaseParameters truth, int averages, unsigned seed) {
    truth.sleeper_passing.amplitude_factor = 0.0;
    truth.frequency = {.from_hz = 2.0, .to_hz = 170.0, .step_hz = 0.5};
    recordings::Recording recording;
    recording.description.kind = recordings::RecordingKind::psd;
    recording.description.speed_m_per_s = 80.0 / 3.6;
    recording.description.averages = averages;
    const pem::Solution solution = pem::solve_case(truth, recording.description.speed_m_per_s, {.threads = 2});
    std::mt19937_64 random(seed);
    std::gamma_distribution<double> chi(averages, 1.0 / averages);
    const auto add = [&](const char* name, recordings::Location location, int index, const char* where) {
        recordings::ChannelSpectrum spectrum{.description = {.name = name, .location = location, .index = index}};
        spectrum.frequency_hz = solution.frequency_hz;
        for (const double value : pem::response_psd(solution, pem::response_index(where))) {
            spectrum.psd.push_back(value * chi(random));
            spectrum.standard_error.push_back(spectrum.psd.back() / std::sqrt(averages));
        }
        recording.spectra.push_back(std::move(spectrum));
    };
    add("axlebox_1", recordings::Location::wheel, 1, "wheel_1");
    add("bogie_1", recordings::Location::bogie, 1, "bogie_1");
    add("body_centre", recordings::Location::body, 0, "body");
    return recording;
}

inline Diagnosis diagnosed(const BelievedCase& believed, const std::vector<recordings::Recording>& recordings) {
    std::vector<Observation> observations;
    for (std::size_t i = 0; i < recordings.size(); ++i)
        observations.push_back(
            observe_scalars(recordings[i], "recording " + std::to_string(i + 1), believed.numbers, {}));
    return diagnose(believed, observations, {.threads = 2});
}

}  // namespace railpem::diagnosis
