#include "diagnosis/observations/observe.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "diagnosis/observations/channel_scales.hpp"
#include "diagnosis/observations/held_distortion.hpp"
#include "parameters/parameter_error.hpp"
#include "recordings/estimates/cross_spectra.hpp"
#include "recordings/estimates/running_speed.hpp"
#include "recordings/stated_speed.hpp"
#include "vehicle/vehicle_parameters.hpp"

namespace railpem::diagnosis {

namespace {

MeasuredSpectra kept(const recordings::CrossSpectra& spectra, const std::vector<ObservedChannel>& channels,
                     std::size_t first, std::size_t count) {
    MeasuredSpectra measured;
    const std::size_t size = channels.size();
    measured.averages = spectra.averages_per_bin;
    measured.values.reserve(count * size * size);
    for (std::size_t bin = first; bin < first + count; ++bin)
        for (std::size_t column = 0; column < size; ++column)
            for (std::size_t row = 0; row < size; ++row)
                measured.values.push_back(spectra.at(bin, channels[row].channel, channels[column].channel));
    set_log_determinants(measured, size, spectra.averages);
    return measured;
}

/// White noise of a channel, from the quietest bins of the record: an upper guess for the fit to start from.
double quiet_level(const recordings::CrossSpectra& spectra, std::size_t channel) {
    std::vector<double> values;
    for (std::size_t bin = 1; bin + 1 < spectra.bins(); ++bin) values.push_back(spectra.psd(bin, channel));
    const std::size_t quiet = values.size() / kObservationSettings.quietest_of;
    std::nth_element(values.begin(), values.begin() + static_cast<long>(quiet), values.end());
    return std::max(values[quiet], 1e-30);
}

recordings::VehicleGeometry geometry_of(const vehicle::VehicleParameters& vehicle) {
    const std::vector<double> wheels = vehicle::wheel_positions(vehicle);
    recordings::VehicleGeometry geometry;
    std::copy(wheels.begin(), wheels.end(), geometry.wheels_m.begin());
    geometry.bogies_m = {0.5 * vehicle.bogie_distance_m, -0.5 * vehicle.bogie_distance_m};
    return geometry;
}

/// The speed as a function of time where the channels say it and it changes; its mean is as `stated`.
std::optional<recordings::RunningSpeed> changing_speed(const recordings::TimeSeries& series,
                                                       const pem::CaseParameters& believed, double stated) {
    std::optional<recordings::RunningSpeed> running =
        recordings::running_speed(series, geometry_of(believed.vehicle), stated);
    if (!running || running->agreement < kObservationSettings.least_speed_agreement) return std::nullopt;
    std::vector<double>& speeds = running->path.speed_m_per_s;
    double mean = 0.0, variance = 0.0;
    for (const double v : speeds) mean += v / static_cast<double>(speeds.size());
    for (const double v : speeds) variance += std::pow(v / mean - 1.0, 2) / static_cast<double>(speeds.size());
    const double least = std::max(kObservationSettings.least_speed_change, 2.0 * running->relative_error);
    if (variance < least * least) return std::nullopt;
    return running;
}

/// Cycles between the outermost wheels at the end of a band.
double most_cycles(const pem::CaseParameters& believed, double high_hz, double speed) {
    const std::vector<double> wheels = vehicle::wheel_positions(believed.vehicle);
    const auto [rear, front] = std::minmax_element(wheels.begin(), wheels.end());
    return kExpectationSettings.coherence_reach * (high_hz + kExpectationSettings.coherence_reach_hz) *
           (*front - *rear) / speed;
}

/// Spectra of all parts of a recording in windows of one length. `running`: its speed, where that changes.
Observation windowed(const recordings::Recording& recording, Observation observation,
                     const pem::CaseParameters& believed, const ObservationOptions& options, double window_s,
                     const std::optional<recordings::RunningSpeed>& running) {
    const recordings::TimeSeries& series = recording.series;
    const double held_from = series.duration_s() * (1.0 - options.held_out_share);
    const recordings::SegmentOptions segments{.window_s = window_s};
    const recordings::CrossSpectra all = recordings::estimate_cross_spectra(series, segments);
    observation.channels = observed_channels(all.channels, believed);
    if (observation.channels.empty())
        throw parameters::ParameterError("channel", "none of the channels is a response that the case has",
                                         "channels on body centre, body over the pivots, bogies, wheels or rail");
    if (observation.channels.size() > static_cast<std::size_t>(kMostChannels))
        throw parameters::ParameterError(
            "channel", fmt::format("{} channels are responses of the case", observation.channels.size()),
            fmt::format("at most {} of them in a recording", kMostChannels));
    set_band(observation, all.kernel(), believed, options);
    const std::size_t bins = band_bins(observation);
    const auto part = [&](double from, double to) {
        recordings::SegmentOptions own = segments;
        own.from_s = from;
        own.to_s = to;
        const recordings::CrossSpectra spectra = recordings::estimate_cross_spectra(series, own);
        MeasuredSpectra measured = kept(spectra, observation.channels, observation.first_bin(), bins);
        measured.seconds = std::min(to, series.duration_s()) - from;
        if (running)
            measured.speeds = std::make_shared<const SpeedMixture>(
                running->path, spectra.segments, series.sampling_rate_hz, from, observation.speed_m_per_s,
                running->relative_error,
                most_cycles(believed, observation.expectation.high_hz, observation.speed_m_per_s));
        return measured;
    };
    observation.all = part(0.0, 1e300);
    observation.fitted = part(0.0, held_from);
    observation.held_out = part(held_from, 1e300);
    for (const ObservedChannel& channel : observation.channels) {
        observation.channel_names.push_back(all.channels[channel.channel].name);
        observation.unknown_scale.push_back(all.channels[channel.channel].scale == recordings::Scale::unknown);
        observation.calibration.push_back(all.channels[channel.channel].gain_standard_error);
        observation.noise_psd.push_back(quiet_level(all, channel.channel));
    }
    return observation;
}

/// The same in short windows, where they hold bins enough.
std::shared_ptr<const Observation> coarse_of(const recordings::Recording& recording, const Observation& head,
                                             const Observation& fine, const pem::CaseParameters& believed,
                                             const ObservationOptions& options,
                                             const std::optional<recordings::RunningSpeed>& running) {
    if (static_cast<double>(fine.bins()) * options.coarse_window_s <
        static_cast<double>(kObservationSettings.fewest_bins) * options.window_s)
        return {};
    Observation coarse = windowed(recording, head, believed, options, options.coarse_window_s, running);
    coarse.expectation.transfer_step_hz = kObservationSettings.coarse_transfer_step_hz;
    coarse.expectation.rail_every =
        static_cast<int>(kExpectationSettings.rail_step_hz / kObservationSettings.coarse_transfer_step_hz);
    coarse.expectation.sharp = false;
    coarse.expectation.contacts = fine.expectation.contacts;
    coarse.log_scale = fine.log_scale;
    coarse.noise_psd = fine.noise_psd;  // where beliefs about noise begin
    return std::make_shared<const Observation>(std::move(coarse));
}

}  // namespace

Observation observe(const recordings::Recording& recording, const std::string& name,
                    const pem::CaseParameters& believed, const ObservationOptions& options) {
    const recordings::StatedSpeed speed = recordings::stated_speed(recording);
    Observation head{.name = name, .speed_m_per_s = speed.m_per_s, .payload_kg = recording.description.payload_kg};
    head.speed_tolerance =
        speed.standard_error > 0.0 ? speed.standard_error / speed.m_per_s : kObservationSettings.speed_tolerance;
    head.observed_speed = {speed.from_channel ? "the speed channel" : "the description", speed.lowest_m_per_s,
                           speed.highest_m_per_s};
    const std::optional<recordings::RunningSpeed> running =
        changing_speed(recording.series, believed, head.speed_m_per_s);
    if (running) {
        const auto [least, most] = std::ranges::minmax_element(running->path.speed_m_per_s);
        head.observed_speed = {"delays between channels", *least, *most};
        head.speed_m_per_s = running->path.mean_m_per_s();
    }
    Observation observation = windowed(recording, head, believed, options, options.window_s, running);
    hold_contact_distortion(observation, believed);
    guess_scales(observation, believed);
    observation.coarse = coarse_of(recording, head, observation, believed, options, running);
    return observation;
}

}  // namespace railpem::diagnosis
