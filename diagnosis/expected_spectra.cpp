#include "diagnosis/expected_spectra.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>

#include "pem/excitation.hpp"
#include "pem/linearise.hpp"
#include "pem/sensor_chain.hpp"
#include "pem/solution.hpp"
#include "pem/wheel_transfers.hpp"

namespace railpem::diagnosis {

namespace {

using Complex = std::complex<double>;

constexpr double kSamePlace = 0.25;  ///< m: a sensor on the body counts as over the pivot or at the centre within this
constexpr int kReachBins = 8;        ///< of the kernel; a Hann window leaves 1e-8 outside

std::string response_of(const recordings::ChannelDescription& channel, const pem::CaseParameters& parameters) {
    using recordings::Location;
    if (channel.quantity != recordings::ChannelQuantity::acceleration) return {};
    switch (channel.location) {
        case Location::wheel: return "wheel_" + std::to_string(channel.index);
        case Location::bogie: return "bogie_" + std::to_string(channel.index);
        case Location::rail: return "rail_" + std::to_string(channel.index);
        case Location::body: {
            const double pivot = parameters.vehicle.bogie_distance_m / 2.0;
            if (std::abs(channel.position_m) < kSamePlace) return "body";
            if (std::abs(channel.position_m - pivot) < kSamePlace) return "body_front";
            if (std::abs(channel.position_m + pivot) < kSamePlace) return "body_rear";
            return {};
        }
        case Location::none: return {};
    }
    return {};
}

/// The fine grid that the kernel needs around the asked bins.
struct FineGrid {
    double step_hz;
    std::size_t first, count;  ///< indices from frequency 0
};

FineGrid fine_grid(const recordings::WindowKernel& kernel, std::size_t first_bin, std::size_t bins, int oversampling) {
    const std::size_t reach = static_cast<std::size_t>(kReachBins * oversampling);
    const std::size_t low = first_bin * static_cast<std::size_t>(oversampling);
    const std::size_t first = low > reach ? low - reach : 1;
    const std::size_t last = (first_bin + bins - 1) * static_cast<std::size_t>(oversampling) + reach;
    return {kernel.bin_hz() / oversampling, first, last - first + 1};
}

/// Sensor factors of the observed channels at a frequency.
std::vector<Complex> sensor_factors(const pem::CaseParameters& parameters, const std::vector<ObservedChannel>& channels, double frequency) {
    std::vector<Complex> factors(channels.size(), 1.0);
    for (const pem::SensorParameters& sensor : parameters.sensors)
        for (std::size_t c = 0; c < channels.size(); ++c)
            if (pem::measured_response(sensor.channel) == pem::response_names()[channels[c].response].where) factors[c] *= pem::sensor_transfer(sensor, frequency);
    return factors;
}

/// Transfers of all channels at one frequency, sensors included: channels × 4.
Eigen::MatrixXcd transfers_at(const pem::CaseParameters& parameters, const std::vector<ObservedChannel>& channels, const pem::WheelTransfers& transfers, double frequency) {
    Eigen::Matrix<Complex, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> matrix(static_cast<long>(channels.size()), 4);
    pem::interpolate(transfers, frequency, matrix.data());
    if (!parameters.sensors.empty()) {
        const std::vector<Complex> factors = sensor_factors(parameters, channels, frequency);
        for (std::size_t c = 0; c < factors.size(); ++c) matrix.row(static_cast<long>(c)) *= factors[c];
    }
    return matrix;
}

/// Pseudo-responses of one broadband source on the fine grid: [channel][fine line].
std::vector<std::vector<Complex>> fine_responses(const pem::CaseParameters& parameters, const std::vector<ObservedChannel>& channels, const pem::WheelTransfers& transfers,
                                                 const pem::DelayedSpectrum& source, const std::vector<double>& wheels, double speed, const FineGrid& grid) {
    std::vector<std::vector<Complex>> y(channels.size(), std::vector<Complex>(grid.count));
    for (std::size_t i = 0; i < grid.count; ++i) {
        const double f = static_cast<double>(grid.first + i) * grid.step_hz;
        const double root = std::sqrt(source.psd_m2_per_hz(f));
        Eigen::Vector4cd e;
        for (std::size_t j = 0; j < 4; ++j) e(static_cast<long>(j)) = root * pem::delay_phase(wheels, j, f, speed);
        const Eigen::VectorXcd response = transfers_at(parameters, channels, transfers, f) * e;
        for (std::size_t c = 0; c < channels.size(); ++c) y[c][i] = response(static_cast<long>(c));
    }
    return y;
}

/// Adds ∫K S df' of a rank-one source to the matrices.
void add_broadband(const std::vector<std::vector<Complex>>& y, const recordings::KernelWeights& kernel, const FineGrid& grid, ExpectedSpectra& expected) {
    const std::size_t reach = static_cast<std::size_t>(kernel.reach_bins * kernel.oversampling);
    const long channels = static_cast<long>(y.size());
    std::vector<Complex> product(grid.count);
    for (long a = 0; a < channels; ++a)
        for (long b = 0; b <= a; ++b) {
            for (std::size_t i = 0; i < grid.count; ++i) product[i] = y[static_cast<std::size_t>(a)][i] * std::conj(y[static_cast<std::size_t>(b)][i]);
            for (std::size_t bin = 0; bin < expected.matrices.size(); ++bin) {
                const std::size_t centre = (expected.first_bin + bin) * static_cast<std::size_t>(kernel.oversampling);
                const std::size_t from = std::max(grid.first, centre > reach ? centre - reach : 0);
                const std::size_t to = std::min(grid.first + grid.count - 1, centre + reach);
                Complex sum = 0.0;
                for (std::size_t i = from; i <= to; ++i) sum += kernel.weights[i + reach - centre] * product[i - grid.first];
                expected.matrices[bin](a, b) += sum;
                if (a != b) expected.matrices[bin](b, a) += std::conj(sum);
            }
        }
}

/// Adds the lines of a set: each a Gaussian of the speed's fluctuation, smoothed by the kernel (five-point Gauss–Hermite rule).
void add_lines(const pem::CaseParameters& parameters, const std::vector<ObservedChannel>& channels, const pem::WheelTransfers& transfers, const pem::LineSet& set,
               const recordings::WindowKernel& kernel, ExpectedSpectra& expected) {
    constexpr double kNodes[5] = {-2.8569700138728, -1.3556261799742, 0.0, 1.3556261799742, 2.8569700138728};
    constexpr double kWeights[5] = {0.0112574113277, 0.2220759220056, 0.5333333333333, 0.2220759220056, 0.0112574113277};
    const double bin = kernel.bin_hz();
    for (const pem::SpectralLine& line : set.lines) {
        Eigen::Vector4cd amplitude;
        for (std::size_t j = 0; j < 4; ++j) amplitude(static_cast<long>(j)) = line.amplitude_m[j];
        const Eigen::VectorXcd response = transfers_at(parameters, channels, transfers, line.frequency_hz) * amplitude;
        const Eigen::MatrixXcd power = 0.5 * response * response.adjoint();
        const double deviation = parameters.running.speed_fluctuation * line.frequency_hz;
        for (std::size_t b = 0; b < expected.matrices.size(); ++b) {
            const double distance = static_cast<double>(expected.first_bin + b) * bin - line.frequency_hz;
            if (std::abs(distance) > kReachBins * bin + 3.0 * deviation) continue;
            double density = 0.0;
            for (int k = 0; k < 5; ++k) density += kWeights[k] * kernel(distance - kNodes[k] * deviation);
            expected.matrices[b] += density * power;
        }
    }
}

}  // namespace

std::vector<ObservedChannel> observed_channels(const std::vector<recordings::ChannelDescription>& channels, const pem::CaseParameters& parameters) {
    std::vector<ObservedChannel> observed;
    for (std::size_t c = 0; c < channels.size(); ++c)
        if (const std::string where = response_of(channels[c], parameters); !where.empty()) observed.push_back({c, pem::response_index(where)});
    return observed;
}

ExpectedSpectra expected_spectra(const pem::CaseParameters& parameters, double speed, const recordings::WindowKernel& kernel, const std::vector<ObservedChannel>& channels,
                                 const std::vector<double>& noise_psd, const ExpectationOptions& options) {
    const double bin = kernel.bin_hz();
    ExpectedSpectra expected;
    expected.first_bin = static_cast<std::size_t>(std::ceil(options.low_hz / bin));
    const std::size_t bins = static_cast<std::size_t>(options.high_hz / bin) - expected.first_bin + 1;
    const long size = static_cast<long>(channels.size());
    expected.matrices.assign(bins, Eigen::MatrixXcd::Zero(size, size));

    pem::CoupledModel model = pem::coupled_model(parameters, speed);
    pem::linearise(parameters, pem::excitation_sources(parameters, model.wheels_m, speed), model);
    std::vector<std::size_t> responses;
    for (const ObservedChannel& channel : channels) responses.push_back(channel.response);
    const FineGrid grid = fine_grid(kernel, expected.first_bin, bins, options.oversampling);
    const double low = static_cast<double>(grid.first) * grid.step_hz, high = static_cast<double>(grid.first + grid.count) * grid.step_hz;
    const double from = std::max(options.transfer_step_hz, low - 2.0 * options.transfer_step_hz);
    const std::size_t lines = static_cast<std::size_t>((high - from) / options.transfer_step_hz) + 4;
    const pem::WheelTransfers transfers = pem::wheel_transfers(model, from, options.transfer_step_hz, lines, responses, options.threads);

    const recordings::KernelWeights weights = recordings::kernel_weights(kernel, options.oversampling, kReachBins);
    const pem::Excitation excitation = pem::excitation(parameters, model.wheels_m, speed);
    for (const pem::DelayedSpectrum& source : excitation.broadband)
        add_broadband(fine_responses(parameters, channels, transfers, source, model.wheels_m, speed, grid), weights, grid, expected);
    for (const pem::LineSet& set : excitation.lines) add_lines(parameters, channels, transfers, set, kernel, expected);
    for (Eigen::MatrixXcd& matrix : expected.matrices)
        for (long c = 0; c < size; ++c) matrix(c, c) += noise_psd[static_cast<std::size_t>(c)];
    return expected;
}

std::vector<double> whitened_trace(const ExpectedSpectra& expected, const recordings::CrossSpectra& measured, const std::vector<ObservedChannel>& channels) {
    const long size = static_cast<long>(channels.size());
    std::vector<double> trace;
    Eigen::MatrixXcd kept(size, size);
    for (std::size_t b = 0; b < expected.matrices.size(); ++b) {
        for (long i = 0; i < size; ++i)
            for (long j = 0; j < size; ++j)
                kept(i, j) = measured.at(expected.first_bin + b, channels[static_cast<std::size_t>(i)].channel, channels[static_cast<std::size_t>(j)].channel);
        trace.push_back(expected.matrices[b].llt().solve(kept).trace().real() / static_cast<double>(size));
    }
    return trace;
}

}  // namespace railpem::diagnosis
