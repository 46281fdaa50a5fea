#include "diagnosis/observations/observe_scalars.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "diagnosis/observations/reference_band.hpp"
#include "parameters/parameter_error.hpp"

namespace railpem::diagnosis {

namespace {

using parameters::ParameterError;
using recordings::RecordingKind;

/// The values that a recording of the track brings; what is not positive has no logarithm and is left out.
std::vector<ScalarValue> track_values(const recordings::Recording& recording) {
    std::vector<ScalarValue> values;
    if (recording.description.kind == RecordingKind::receptance) {
        const recordings::MeasuredReceptance& receptance = recording.receptance;
        for (std::size_t i = 0; i < receptance.frequency_hz.size(); ++i)
            if (std::abs(receptance.value_m_per_n[i]) > 0.0 && receptance.frequency_hz[i] > 0.0)
                values.push_back({.frequency_hz = receptance.frequency_hz[i],
                                  .log_value = std::log(receptance.value_m_per_n[i]),
                                  .deviation = kObservationSettings.receptance_deviation});
        return values;
    }
    const recordings::MeasuredDecayRate& decay = recording.decay_rate;
    for (std::size_t i = 0; i < decay.centre_hz.size(); ++i) {
        const double value = decay.decay_rate_db_per_m[i];
        if (!(value > 0.0) || !(decay.centre_hz[i] > 0.0)) continue;
        const double stated = decay.standard_error_db_per_m.empty() ? 0.0 : decay.standard_error_db_per_m[i] / value;
        values.push_back({.frequency_hz = decay.centre_hz[i],
                          .log_value = std::log(value),
                          .deviation = stated > 0.0 ? stated : kObservationSettings.decay_deviation});
    }
    return values;
}

/// The logarithm of a mean of n exponentials lies 1/2n below that of its expectation.
double log_bias(int averages) {
    return averages > 0 ? 0.5 / averages : 0.0;
}

std::vector<ScalarValue> spectrum_values(const recordings::Recording& recording, const Observation& observation) {
    std::vector<ScalarValue> values;
    for (std::size_t c = 0; c < observation.channels.size(); ++c) {
        const recordings::ChannelSpectrum& spectrum = recording.spectra[observation.channels[c].channel];
        for (std::size_t i = 0; i < spectrum.frequency_hz.size(); ++i) {
            const double f = spectrum.frequency_hz[i];
            if (!(spectrum.psd[i] > 0.0) || f < observation.expectation.low_hz || f > observation.expectation.high_hz)
                continue;
            const double stated = spectrum.standard_error.empty() ? 0.0 : spectrum.standard_error[i] / spectrum.psd[i];
            values.push_back({.channel = c,
                              .frequency_hz = f,
                              .log_value = std::log(spectrum.psd[i]) + log_bias(recording.description.averages),
                              .deviation = stated > 0.0 ? stated : kObservationSettings.spectrum_deviation});
        }
    }
    return values;
}

/// Smallest distance of neighbouring lines.
double spacing_of(const std::vector<recordings::ChannelSpectrum>& spectra) {
    double spacing = 1e300;
    for (const recordings::ChannelSpectrum& spectrum : spectra)
        for (std::size_t i = 1; i < spectrum.frequency_hz.size(); ++i)
            spacing = std::min(spacing, spectrum.frequency_hz[i] - spectrum.frequency_hz[i - 1]);
    return spacing < 1e300 ? spacing : 0.0;
}

/// Lines of passing sleepers stand out of a measured spectrum by an amount that depends on its window.
void leave_out_passing(const pem::CaseParameters& believed, double speed, ScalarData& data) {
    const double first = speed / believed.track.spacing_m;
    const std::size_t before = data.values.size();
    std::erase_if(data.values, [&](const ScalarValue& value) {
        const double distance =
            std::abs(value.frequency_hz - first * std::max(1.0, std::round(value.frequency_hz / first)));
        return distance < kObservationSettings.passing_reach_lines * data.resolution_hz;
    });
    if (data.values.size() < before)
        data.lacks.push_back(
            fmt::format("{} lines beside the passing frequency of the sleepers and its multiples are left out",
                        before - data.values.size()));
}

/// Four wheels make zeros, which no window resolves and which a hair's breadth of speed moves. A level far below the
/// mean of its third-octave is not believed; without a scale nothing can be added to it, and it is left out.
void raise_zeros(const std::vector<bool>& unknown_scale, ScalarData& data) {
    std::vector<double> levels;
    for (const ScalarValue& value : data.values) levels.push_back(std::exp(value.log_value.real()));
    const std::vector<double> means = third_octave_means(data.values, levels);
    for (std::size_t i = 0; i < data.values.size(); ++i) {
        data.values[i].pedestal_share = kObservationSettings.pedestal;
        data.values[i].pedestal = kObservationSettings.pedestal * means[i];
    }
    std::erase_if(data.values, [&](const ScalarValue& value) {
        return unknown_scale[value.channel] && std::exp(value.log_value.real()) < value.pedestal;
    });
    for (ScalarValue& value : data.values) {
        if (unknown_scale[value.channel]) value.pedestal = value.pedestal_share = 0.0;
        const double level = std::exp(value.log_value.real());
        value.log_value = std::log(level + value.pedestal);
        value.deviation *= level / (level + value.pedestal);
    }
}

/// How well the reference of the case is known, where it has one.
void refer(const pem::DecayRateReference& reference, ScalarData& data) {
    for (ScalarValue& value : data.values)
        if (const int band = reference_band(reference, value.frequency_hz); band >= 0)
            value.shared_deviation = reference.relative_error[static_cast<std::size_t>(band)];
}

void prepare_spectrum(const recordings::Recording& recording, const pem::CaseParameters& believed,
                      const ObservationOptions& options, Observation& observation) {
    observation.speed_m_per_s = recording.description.speed_m_per_s;
    if (!(observation.speed_m_per_s > 0.0))
        throw ParameterError("speed_m_per_s", "channels of a running train without its speed",
                             "the speed at which they were recorded");
    const double error = recording.description.speed_standard_error_m_per_s;
    observation.speed_tolerance =
        error > 0.0 ? error / observation.speed_m_per_s : kObservationSettings.speed_tolerance;
    std::vector<recordings::ChannelDescription> described;
    for (const recordings::ChannelSpectrum& spectrum : recording.spectra) described.push_back(spectrum.description);
    observation.channels = observed_channels(described, believed);
    if (observation.channels.empty())
        throw ParameterError("channel", "none of the channels is a response that the case has",
                             "channels on body centre, body over the pivots, bogies, wheels or rail");
    for (const ObservedChannel& channel : observation.channels) {
        observation.channel_names.push_back(described[channel.channel].name);
        observation.unknown_scale.push_back(described[channel.channel].scale == recordings::Scale::unknown);
    }
    double longest = 0.0, shortest = 1e300;
    for (const spectra::IrregularityBand& band : believed.irregularity.bands) {
        longest = std::max(longest, band.longest_wavelength_m);
        shortest = std::min(shortest, band.shortest_wavelength_m);
    }
    const double v = observation.speed_m_per_s;
    observation.expectation.low_hz = std::max(options.low_hz, v / longest / kObservationSettings.band_edge);
    observation.expectation.high_hz = std::min(options.high_hz, kObservationSettings.band_edge * v / shortest);
    observation.scalar->values = spectrum_values(recording, observation);
    if (recording.description.kind == RecordingKind::psd) {
        observation.scalar->resolution_hz = spacing_of(recording.spectra);
        leave_out_passing(believed, v, *observation.scalar);
        raise_zeros(observation.unknown_scale, *observation.scalar);
    }
    if (observation.scalar->values.empty())
        throw ParameterError("speed_m_per_s",
                             fmt::format("at {:g} m/s no value lies in the usable band from {:.3g} to {:.3g} Hz", v,
                                         observation.expectation.low_hz, observation.expectation.high_hz),
                             "values within what the irregularity of the case excites at this speed");
}

/// Values of the same twelfth of an octave share their discrepancy; one third-octave in four is held out, the third
/// first.
void share_and_hold_out(ScalarData& data) {
    std::map<std::pair<std::size_t, long>, double> cells;
    std::set<long> bands;
    const auto cell = [](const ScalarValue& value) {
        return std::pair(value.channel, discrepancy_cell(value.frequency_hz));
    };
    const auto band = [](const ScalarValue& value) { return std::lround(10.0 * std::log10(value.frequency_hz)); };
    for (ScalarValue& value : data.values) {
        value.deviation = std::max(value.deviation, kObservationSettings.least_deviation);
        cells[cell(value)] += 1.0;
        bands.insert(band(value));
    }
    std::set<long> held;
    int place = 0;
    for (const long own : bands)
        if (place++ % kObservationSettings.held_out_band() == kObservationSettings.first_held_out_band)
            held.insert(own);
    for (ScalarValue& value : data.values) {
        value.sharing = cells[cell(value)];
        value.held_out = held.count(band(value)) > 0;
    }
    if (held.empty())
        data.lacks.emplace_back("fewer than three third-octaves: none can be held out, so nothing can be named");
}

}  // namespace

Observation observe_scalars(const recordings::Recording& recording, const std::string& name,
                            const pem::CaseParameters& believed, const ObservationOptions& options) {
    Observation observation{.name = name, .payload_kg = recording.description.payload_kg};
    observation.expectation.threads = 1;  // many evaluations run side by side
    observation.scalar = ScalarData{.kind = recording.description.kind, .place = recording.description.place};
    ScalarData& data = *observation.scalar;
    data.lacks = recording.lacks;
    if (data.of_track()) {
        data.has_phase = data.kind == RecordingKind::receptance && recording.receptance.has_phase;
        data.values = track_values(recording);
        if (data.kind == RecordingKind::decay_rate) refer(believed.decay_rate_reference, data);
        observation.channel_names = {data.kind == RecordingKind::decay_rate      ? "decay rate"
                                     : data.place == recordings::Place::over_pad ? "receptance over a pad"
                                                                                 : "receptance in mid-bay"};
        if (data.values.empty())
            throw ParameterError("data", "no value is greater than zero",
                                 "a receptance or decay rate that is not all zero");
        const double reach = data.kind == RecordingKind::decay_rate ? std::pow(10.0, 0.05) : 1.0;
        observation.expectation.low_hz = data.values.front().frequency_hz / reach;
        observation.expectation.high_hz = data.values.back().frequency_hz * reach;
    } else {
        prepare_spectrum(recording, believed, options, observation);
    }
    share_and_hold_out(data);
    return observation;
}

}  // namespace railpem::diagnosis
