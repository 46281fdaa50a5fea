#include "diagnosis/observation.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "diagnosis/channel_scales.hpp"
#include "diagnosis/held_distortion.hpp"
#include "parameters/parameter_error.hpp"
#include "recordings/cross_spectra.hpp"
#include "recordings/stated_speed.hpp"
#include "vehicle/vehicle_parameters.hpp"

namespace railpem::diagnosis {

namespace {

constexpr std::size_t kFewestBins = 20;
/// Hz: what an axle box leaves unsaid by the others, 1e-5 of its power, is met within 2 %
constexpr double kTransferStep = 0.125;
constexpr double kCoarseTransferStep = 0.5;  ///< 3e-5 of that power: nothing where the floor is a tenth
constexpr double kRailStep = 2.0;            ///< Hz

/// Fine lines per bin: the kernel repeats beyond its own length and every wheel delay, both ways.
int oversampling_of(double window_s, const pem::CaseParameters& believed, double speed_m_per_s) {
    const std::vector<double> wheels = vehicle::wheel_positions(believed.vehicle);
    const auto [rear, front] = std::minmax_element(wheels.begin(), wheels.end());
    return static_cast<int>(std::ceil(2.0 * (1.0 + (*front - *rear) / speed_m_per_s / window_s)));
}

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

/// Longest and shortest wave that the believed irregularity has.
std::pair<double, double> wavelengths(const spectra::IrregularityParameters& irregularity) {
    double longest = 0.0, shortest = 1e300;
    for (const spectra::IrregularityBand& band : irregularity.bands) {
        longest = std::max(longest, band.longest_wavelength_m);
        shortest = std::min(shortest, band.shortest_wavelength_m);
    }
    return {longest, shortest};
}

/// White noise of a channel, from the quietest bins of the record: an upper guess for the fit to start from.
double quiet_level(const recordings::CrossSpectra& spectra, std::size_t channel) {
    std::vector<double> values;
    for (std::size_t bin = 1; bin + 1 < spectra.bins(); ++bin) values.push_back(spectra.psd(bin, channel));
    std::nth_element(values.begin(), values.begin() + static_cast<long>(values.size() / 50), values.end());
    return std::max(values[values.size() / 50], 1e-30);
}

}  // namespace

std::size_t Observation::first_bin() const {
    return static_cast<std::size_t>(std::ceil(expectation.low_hz / kernel.bin_hz()));
}

std::size_t band_bins(const Observation& observation) {
    const double count = std::floor(observation.expectation.high_hz / observation.kernel.bin_hz()) -
                         std::ceil(observation.expectation.low_hz / observation.kernel.bin_hz()) + 1.0;
    return count > 0.0 ? static_cast<std::size_t>(count) : 0;
}

void set_band(Observation& observation, const recordings::WindowKernel& kernel, const pem::CaseParameters& believed,
              const ObservationOptions& options) {
    observation.kernel = kernel;
    const auto [longest, shortest] = wavelengths(believed.irregularity);
    const double v = observation.speed_m_per_s;
    if (!(v > 0.0))
        throw parameters::ParameterError(
            "speed_m_per_s", "is missing: a time series is told from others by how fast the irregularity passes",
            "the mean speed in m/s, to a percent or so (its error is estimated)");
    observation.expectation.low_hz = std::max(options.low_hz, v / longest / kBandEdge);
    observation.expectation.high_hz =
        std::min({options.high_hz, kBandEdge * v / shortest, 0.4 * kernel.sampling_rate_hz});
    observation.expectation.oversampling = oversampling_of(1.0 / kernel.bin_hz(), believed, v);
    observation.expectation.weights = expectation_weights(kernel, observation.expectation.oversampling);
    observation.expectation.transfer_step_hz = kTransferStep;
    observation.expectation.rail_every = static_cast<int>(kRailStep / kTransferStep);
    observation.expectation.threads = 1;  // many evaluations run side by side
    if (band_bins(observation) < kFewestBins)
        throw parameters::ParameterError(
            "speed_m_per_s",
            fmt::format("at {:g} m/s no usable band is left between {:.3g} and {:.3g} Hz", v,
                        observation.expectation.low_hz, observation.expectation.high_hz),
            "a speed at which the irregularity of the case excites the band of the recording");
}

void set_log_determinants(MeasuredSpectra& measured, std::size_t channels, double averages) {
    const long size = static_cast<long>(channels);
    const std::size_t bins = measured.values.size() / (channels * channels);
    measured.log_determinant.assign(bins, 0.0);
    if (averages < static_cast<double>(channels)) return;
    for (std::size_t bin = 0; bin < bins; ++bin) {
        const Eigen::Map<const Eigen::MatrixXcd> matrix(&measured.values[bin * channels * channels], size, size);
        const Eigen::LLT<Eigen::MatrixXcd> factor(matrix);
        double sum = 0.0;
        for (long i = 0; i < size; ++i) sum += 2.0 * std::log(factor.matrixLLT()(i, i).real());
        if (std::isfinite(sum)) measured.log_determinant[bin] = sum;
    }
}

namespace {

/// Spectra of all parts of a recording in windows of one length.
Observation windowed(const recordings::Recording& recording, Observation observation,
                     const pem::CaseParameters& believed, const ObservationOptions& options, double window_s) {
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
        MeasuredSpectra measured =
            kept(recordings::estimate_cross_spectra(series, own), observation.channels, observation.first_bin(), bins);
        measured.seconds = std::min(to, series.duration_s()) - from;
        return measured;
    };
    observation.all = part(0.0, 1e300);
    observation.fitted = part(0.0, held_from);
    observation.held_out = part(held_from, 1e300);
    for (const ObservedChannel& channel : observation.channels) {
        observation.channel_names.push_back(all.channels[channel.channel].name);
        observation.unknown_scale.push_back(all.channels[channel.channel].scale == recordings::Scale::unknown);
        observation.noise_psd.push_back(quiet_level(all, channel.channel));
    }
    return observation;
}

/// The same in short windows, where they hold bins enough.
std::shared_ptr<const Observation> coarse_of(const recordings::Recording& recording, const Observation& head,
                                             const Observation& fine, const pem::CaseParameters& believed,
                                             const ObservationOptions& options) {
    if (static_cast<double>(fine.bins()) * options.coarse_window_s <
        static_cast<double>(kFewestBins) * options.window_s)
        return {};
    Observation coarse = windowed(recording, head, believed, options, options.coarse_window_s);
    coarse.expectation.transfer_step_hz = kCoarseTransferStep;
    coarse.expectation.rail_every = static_cast<int>(kRailStep / kCoarseTransferStep);
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
    head.speed_tolerance = speed.standard_error > 0.0 ? speed.standard_error / speed.m_per_s : kDefaultSpeedTolerance;
    Observation observation = windowed(recording, head, believed, options, options.window_s);
    hold_contact_distortion(observation, believed);
    guess_scales(observation, believed);
    observation.coarse = coarse_of(recording, head, observation, believed, options);
    return observation;
}

std::vector<Observation> coarse_observations(const std::vector<Observation>& observations) {
    std::vector<Observation> coarse;
    for (const Observation& own : observations) coarse.push_back(own.coarse ? *own.coarse : own);
    return coarse;
}

}  // namespace railpem::diagnosis
