#include "diagnosis/observation.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "parameters/parameter_error.hpp"
#include "recordings/cross_spectra.hpp"

namespace railpem::diagnosis {

namespace {

constexpr double kDefaultSpeedTolerance = 0.005;  ///< of a stated speed without a standard error
constexpr double kEdge = 0.9;  ///< the band ends this much inside of what the irregularity excites
constexpr std::size_t kFewestBins = 20;

MeasuredSpectra kept(const recordings::CrossSpectra& spectra, const std::vector<ObservedChannel>& channels,
                     std::size_t first, std::size_t count) {
    MeasuredSpectra measured;
    const std::size_t size = channels.size();
    measured.averages = spectra.averages_per_bin;
    measured.values.reserve(count * size * size);
    Eigen::MatrixXcd matrix(static_cast<long>(size), static_cast<long>(size));
    const bool enough = spectra.averages >= static_cast<double>(size);
    for (std::size_t bin = first; bin < first + count; ++bin) {
        for (std::size_t column = 0; column < size; ++column)
            for (std::size_t row = 0; row < size; ++row) {
                measured.values.push_back(spectra.at(bin, channels[row].channel, channels[column].channel));
                matrix(static_cast<long>(row), static_cast<long>(column)) = measured.values.back();
            }
        double sum = 0.0;
        if (enough) {
            const Eigen::LLT<Eigen::MatrixXcd> factor(matrix);
            for (long i = 0; i < matrix.rows(); ++i) sum += 2.0 * std::log(factor.matrixLLT()(i, i).real());
        }
        measured.log_determinant.push_back(std::isfinite(sum) ? sum : 0.0);
    }
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

Observation observe(const recordings::Recording& recording, const std::string& name,
                    const pem::CaseParameters& believed, const ObservationOptions& options) {
    Observation observation{.name = name};
    const recordings::TimeSeries& series = recording.series;
    observation.speed_m_per_s = recording.description.speed_m_per_s;
    observation.payload_kg = recording.description.payload_kg;
    observation.speed_tolerance = recording.description.speed_standard_error_m_per_s > 0.0
                                      ? recording.description.speed_standard_error_m_per_s / observation.speed_m_per_s
                                      : kDefaultSpeedTolerance;
    const double held_from = series.duration_s() * (1.0 - options.held_out_share);
    const recordings::SegmentOptions segments{.window_s = options.window_s};
    const recordings::CrossSpectra all = recordings::estimate_cross_spectra(series, segments);
    observation.channels = observed_channels(all.channels, believed);
    if (observation.channels.empty())
        throw parameters::ParameterError("channel", "none of the channels is a response that the case has",
                                         "channels on body centre, body over the pivots, bogies, wheels or rail");
    observation.kernel = all.kernel();
    observation.expectation.weights = expectation_weights(observation.kernel, observation.expectation.oversampling);
    const auto [longest, shortest] = wavelengths(believed.irregularity);
    const double v = observation.speed_m_per_s;
    observation.expectation.low_hz = std::max(options.low_hz, v / longest / kEdge);
    observation.expectation.high_hz = std::min({options.high_hz, kEdge * v / shortest, 0.4 * series.sampling_rate_hz});
    observation.expectation.threads = 1;  // many evaluations run side by side
    const double bin = observation.kernel.bin_hz();
    const double count = std::floor(observation.expectation.high_hz / bin) - std::ceil(observation.expectation.low_hz / bin) + 1.0;
    if (count < static_cast<double>(kFewestBins))
        throw parameters::ParameterError(
            "speed_m_per_s", fmt::format("at {:g} m/s no usable band is left between {:.3g} and {:.3g} Hz", v,
                                         observation.expectation.low_hz, observation.expectation.high_hz),
            "a speed at which the irregularity of the case excites the band of the recording");
    const std::size_t bins = static_cast<std::size_t>(count);
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

}  // namespace railpem::diagnosis
