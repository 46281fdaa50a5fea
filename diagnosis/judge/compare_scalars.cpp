#include "diagnosis/judge/compare_scalars.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "diagnosis/fit/interval.hpp"
#include "diagnosis/likelihood/scalar_likelihood.hpp"
#include "recordings/estimates/confidence.hpp"
#include "spectra/third_octaves.hpp"

namespace railpem::diagnosis {

namespace {

using recordings::RecordingKind;

std::string quantity_of(RecordingKind kind) {
    if (kind == RecordingKind::receptance) return "receptance_m_per_n";
    return kind == RecordingKind::decay_rate ? "decay_rate_db_per_m" : "psd_m2_per_s4_per_hz";
}

int band_of(const ScalarValue& value) {
    return static_cast<int>(std::lround(10.0 * std::log10(value.frequency_hz)));
}

/// Indices of the values of a channel in a part, by third-octave.
std::map<int, std::vector<std::size_t>> values_by_band(const ScalarData& data, std::size_t channel, Part part) {
    std::map<int, std::vector<std::size_t>> bands;
    for (std::size_t i = 0; i < data.values.size(); ++i)
        if (data.values[i].channel == channel && belongs(data.values[i], part))
            bands[band_of(data.values[i])].push_back(i);
    return bands;
}

/// Mean of measured over model over the values of a band, dB. Predictions are log(model/measured).
double band_difference(const ExpectedSpectra& prediction, const std::vector<std::size_t>& values, double db) {
    double sum = 0.0;
    for (const std::size_t i : values) sum -= prediction.values[i].real();
    return db * sum / static_cast<double>(values.size());
}

/// Mean of what is predicted over the values of a band, pedestals included.
double raised_mean(const ScalarData& data, const ExpectedSpectra& prediction, const std::vector<std::size_t>& values) {
    double sum = 0.0;
    for (const std::size_t i : values) sum += std::exp(data.values[i].log_value.real() + prediction.values[i].real());
    return sum / static_cast<double>(values.size());
}

}  // namespace

void compare_scalars(const Stages& stages, const Observation& observation, std::size_t o, Part part,
                     std::vector<ChannelComparison>& channels) {
    const ScalarData& data = *observation.scalar;
    const double db = db_per_neper(data.kind);
    const ExpectedSpectra &believed = (*stages.believed_predictions)[o], &retuned = (*stages.retuned_predictions)[o],
                          &diagnosed = (*stages.diagnosed_predictions)[o];
    for (std::size_t c = 0; c < observation.channel_names.size(); ++c) {
        ChannelComparison result{.recording = observation.name,
                                 .channel = observation.channel_names[c],
                                 .speed_m_per_s = observation.speed_m_per_s,
                                 .quantity = quantity_of(data.kind)};
        for (const auto& [band, values] : values_by_band(data, c, part)) {
            result.band_centre_hz.push_back(spectra::third_octave_band(band).nominal_hz);
            result.band_believed_db.push_back(band_difference(believed, values, db));
            result.band_retuned_db.push_back(band_difference(retuned, values, db));
            result.band_diagnosed_db.push_back(band_difference(diagnosed, values, db));
            for (const std::size_t i : values) {
                const double raised = std::exp(data.values[i].log_value.real()),
                             level = raised - data.values[i].pedestal;
                // a model's pedestal is a share of its mean in the band, of which this is 1 + share
                const auto model = [&](const ExpectedSpectra& prediction) {
                    const double share = data.values[i].pedestal_share;
                    return raised * std::exp(prediction.values[i].real()) -
                           share / (1.0 + share) * raised_mean(data, prediction, values);
                };
                const double reach = std::exp(kNinety * data.values[i].deviation * raised / level);
                result.frequency_hz.push_back(data.values[i].frequency_hz);
                result.measured.push_back(level);
                result.low.push_back(level / reach);
                result.high.push_back(level * reach);
                result.believed.push_back(model(believed));
                result.retuned.push_back(model(retuned));
                result.diagnosed.push_back(model(diagnosed));
            }
        }
        channels.push_back(std::move(result));
    }
}

double scalar_mismatches(const Trial& trial, const Predictions& predictions, const Observation& observation,
                         std::size_t o, Part part, std::vector<Mismatch>& found) {
    const ScalarData& data = *observation.scalar;
    double tests = 0.0;
    for (std::size_t c = 0; c < observation.channel_names.size(); ++c)
        for (const auto& [band, values] : values_by_band(data, c, part)) {
            double squares = 0.0, degrees = 0.0;
            for (const std::size_t i : values) {
                squares += std::norm(predictions[o].values[i]) / scalar_variance(data.values[i], trial.discrepancy[o]);
                degrees += data.has_phase ? 2.0 : 1.0;
            }
            const spectra::ThirdOctaveBand own = spectra::third_octave_band(band);
            tests += 1.0;
            found.push_back({.recording = observation.name,
                             .channel = observation.channel_names[c],
                             .low_hz = own.low_hz,
                             .high_hz = own.high_hz,
                             .level_db = band_difference(predictions[o], values, db_per_neper(data.kind)),
                             .false_alarm_probability = recordings::chi_squared_exceeded(squares, degrees)});
        }
    return tests;
}

}  // namespace railpem::diagnosis
