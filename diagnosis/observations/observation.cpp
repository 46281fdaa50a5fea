#include "diagnosis/observations/observation.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "parameters/parameter_error.hpp"
#include "vehicle/vehicle_parameters.hpp"

namespace railpem::diagnosis {

namespace {

/// Fine lines per bin: the kernel repeats beyond its own length and every wheel delay, both ways.
int oversampling_of(double window_s, const pem::CaseParameters& believed, double speed_m_per_s) {
    const std::vector<double> wheels = vehicle::wheel_positions(believed.vehicle);
    const auto [rear, front] = std::minmax_element(wheels.begin(), wheels.end());
    return static_cast<int>(std::ceil(2.0 * (1.0 + (*front - *rear) / speed_m_per_s / window_s)));
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
    observation.expectation.low_hz = std::max(options.low_hz, v / longest / kObservationSettings.band_edge);
    observation.expectation.high_hz = std::min({options.high_hz, kObservationSettings.band_edge * v / shortest,
                                                kObservationSettings.highest_of_rate * kernel.sampling_rate_hz});
    observation.expectation.oversampling = oversampling_of(1.0 / kernel.bin_hz(), believed, v);
    observation.expectation.weights = expectation_weights(kernel, observation.expectation.oversampling);
    observation.expectation.transfer_step_hz = kObservationSettings.transfer_step_hz;
    observation.expectation.rail_every =
        static_cast<int>(kExpectationSettings.rail_step_hz / kObservationSettings.transfer_step_hz);
    observation.expectation.threads = 1;  // many evaluations run side by side
    if (band_bins(observation) < kObservationSettings.fewest_bins)
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

std::vector<Observation> coarse_observations(const std::vector<Observation>& observations) {
    std::vector<Observation> coarse;
    for (const Observation& own : observations) coarse.push_back(own.coarse ? *own.coarse : own);
    return coarse;
}

}  // namespace railpem::diagnosis
