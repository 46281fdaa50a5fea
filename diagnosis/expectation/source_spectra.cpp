#include "diagnosis/expectation/source_spectra.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "diagnosis/expectation/delay_phases.hpp"
#include "diagnosis/expectation/expectation_settings.hpp"
#include "lanes/complex_lanes.hpp"
#include "pem/coupling/excitation.hpp"
#include "pem/coupling/sensor_chain.hpp"
#include "pem/response_names.hpp"

namespace railpem::diagnosis {

using Complex = std::complex<double>;

namespace {

/// y·yᴴ, column by column.
void add_outer_product(const std::vector<Complex>& y, Complex* power) {
    const std::size_t size = y.size();
    for (std::size_t j = 0; j < size; ++j)
        for (std::size_t i = j; i < size; ++i) {
            const Complex own = y[i] * std::conj(y[j]);
            power[j * size + i] += own;
            if (i != j) power[i * size + j] += std::conj(own);
        }
}

bool differ(double a, double b, double ratio) {
    return std::max(a, b) > ratio * std::min(a, b);
}

/// d ln P/d ln f at a line, over a few per cent of its frequency; 0 where there is no power.
double slope_at(const std::vector<double>& power, const FineGrid& grid, std::size_t line) {
    const double steepest = kExpectationSettings.steepest_slope;
    const auto reach =
        static_cast<std::size_t>(1.0 + kExpectationSettings.slope_reach * grid.frequency(line) / grid.step_hz);
    const std::size_t low = line > reach ? line - reach : 0, high = std::min(line + reach, grid.count - 1);
    if (low == high || power[low] <= 0.0 || power[high] <= 0.0) return 0.0;
    return std::clamp(std::log(power[high] / power[low]) / std::log(grid.frequency(high) / grid.frequency(low)),
                      -steepest, steepest);
}

/// Two complex numbers.
using Pair = double __attribute__((vector_size(4 * sizeof(double))));

/// Σ t_j·e_j over four wheels, in two registers each: as complex numbers one after the other it waited for its own
/// stores.
class Dot {
  public:
    explicit Dot(const Complex* e) {
        for (int half = 0; half < 2; ++half) {
            const Complex a = e[2 * half], b = e[2 * half + 1];
            real_[half] = Pair{a.real(), -a.imag(), b.real(), -b.imag()};
            imaginary_[half] = Pair{a.imag(), a.real(), b.imag(), b.real()};
        }
    }

    Complex operator()(const Complex* t) const {
        Pair front, rear;
        std::memcpy(&front, t, sizeof front);
        std::memcpy(&rear, t + 2, sizeof rear);
        const Pair re = front * real_[0] + rear * real_[1], im = front * imaginary_[0] + rear * imaginary_[1];
        return {(re[0] + re[1]) + (re[2] + re[3]), (im[0] + im[1]) + (im[2] + im[3])};
    }

  private:
    Pair real_[2], imaginary_[2];
};

}  // namespace

// Paired bands may differ 16-fold at their edge; without this the expectation would jump whenever a change of speed
// carries the edge over a line, by tens of nats, and no fit could pass.
double power_over_cell(const pem::DelayedSpectrum& source, double frequency, double step, double centre) {
    double low = frequency - 0.5 * step, high = frequency + 0.5 * step;
    const double at_low = source.psd_m2_per_hz(low), at_high = source.psd_m2_per_hz(high);
    double below = at_low, above = at_high;
    if (!differ(at_low, at_high, kExpectationSettings.suspicious_ratio)) return centre;
    for (int i = 0; i < kExpectationSettings.edge_halvings; ++i) {
        const double middle = 0.5 * (low + high), own = source.psd_m2_per_hz(middle);
        const bool upper = std::abs(std::log((own + 1e-300) / (below + 1e-300))) <
                           std::abs(std::log((own + 1e-300) / (above + 1e-300)));
        (upper ? low : high) = middle;
        (upper ? below : above) = own;
    }
    if (!differ(below, above, kExpectationSettings.edge_ratio)) return centre;
    const double share = (low - frequency) / step + 0.5;  // of the cell, below the edge
    return share * 0.5 * (at_low + below) + (1.0 - share) * 0.5 * (above + at_high);
}

// An edge within a cell stands out between the line and one of its neighbours, too, by as much.
std::vector<double> powers_at_lines(const pem::DelayedSpectrum& source, const FineGrid& grid) {
    const double look_from = kExpectationSettings.look_ratio;
    std::vector<double> at_line(grid.count), power(grid.count);
    for (std::size_t i = 0; i < grid.count; ++i) at_line[i] = source.psd_m2_per_hz(grid.frequency(i));
    for (std::size_t i = 0; i < grid.count; ++i) {
        const double own = at_line[i];
        const bool look = i == 0 || i + 1 == grid.count || differ(at_line[i - 1], own, look_from) ||
                          differ(own, at_line[i + 1], look_from);
        power[i] = look ? power_over_cell(source, grid.frequency(i), grid.step_hz, own) : own;
    }
    return power;
}

std::vector<double> powers_at_lines(const pem::DelayedSpectrum& source, const FineGrid& grid,
                                    const SpeedMixture* speeds) {
    if (!speeds) return powers_at_lines(source, grid);
    const double last = static_cast<double>(grid.first + grid.count);
    const auto below = static_cast<std::size_t>(std::ceil(std::max(0.0, -speeds->least()) * last)) + 1,
               above = static_cast<std::size_t>(std::ceil(std::max(0.0, speeds->most()) * last)) + 2;
    const std::size_t reach = std::min(below, grid.first - 1);  // 0 Hz has no wavelength
    const std::vector<double> at_lines =
        powers_at_lines(source, FineGrid{grid.step_hz, grid.first - reach, grid.count + reach + above});
    std::vector<double> power(grid.count, 0.0);
    for (const double deviation : speeds->nodes())
        for (std::size_t i = 0; i < grid.count; ++i) {
            const double place =
                static_cast<double>(grid.first + i) * (1.0 + deviation) - static_cast<double>(grid.first - reach);
            if (place < 0.0) continue;
            const auto line = static_cast<std::size_t>(place);
            const double share = place - static_cast<double>(line);
            power[i] += (1.0 + deviation) * ((1.0 - share) * at_lines[line] + share * at_lines[line + 1]) /
                        static_cast<double>(speeds->nodes().size());
        }
    return power;
}

MetPowers met_powers(const pem::CaseParameters& parameters, const pem::DelayedSpectrum& irregularity, double speed,
                     const FineGrid& grid, const MetPowers* known, const SpeedMixture* speeds) {
    const double patch = parameters.contact.patch_half_length_m;
    if (known && known->at_lines.size() == grid.count && known->speed_m_per_s == speed &&
        known->patch_half_length_m == patch && known->irregularity == parameters.irregularity)
        return *known;
    return {parameters.irregularity, patch, speed, powers_at_lines(irregularity, grid, speeds)};
}

std::vector<Complex> fine_responses(const pem::WheelTransfers& transfers, const pem::DelayedSpectrum& source,
                                    const std::vector<double>& power, const std::vector<double>& wheels, double speed,
                                    const FineGrid& grid, const SpeedMixture* speeds) {
    const std::size_t channels = transfers.responses.size(), ranks = speeds ? 4 : 1;
    std::vector<Complex> y(ranks * channels * grid.count), at(channels * 4);
    DelayPhases delays(wheels, speed, grid);
    for (std::size_t i = 0; i < grid.count; ++i) {
        const double f = grid.frequency(i), root = std::sqrt(power[i]);
        const std::array<Complex, 4>& delay = delays.at(i);
        if (root == 0.0) continue;
        pem::interpolate(transfers, f, at.data());
        Complex e[4];
        if (source.under_wheels)
            std::ranges::copy(source.under_wheels(f), e);
        else
            for (std::size_t j = 0; j < 4; ++j) e[j] = root * source.share[j] * delay[j];
        if (speeds) {
            const WheelCoherence factor = wheel_coherence(*speeds, wheels, speed, f, slope_at(power, grid, i));
            for (std::size_t r = 0; r < ranks; ++r) {
                Complex own[4];
                for (std::size_t j = 0; j < 4; ++j) own[j] = e[j] * factor[j][r];
                const Dot dot(own);
                for (std::size_t c = 0; c < channels; ++c) y[(r * channels + c) * grid.count + i] = dot(&at[c * 4]);
            }
            continue;
        }
        const Dot dot(e);
        for (std::size_t c = 0; c < channels; ++c) y[c * grid.count + i] = dot(&at[c * 4]);
    }
    return y;
}

pem::WheelTransfers with_what_comes_back(const pem::WheelTransfers& transfers, const pem::FeltOrder& own) {
    pem::WheelTransfers result = transfers;
    const std::size_t channels = transfers.responses.size();
    for (std::size_t line = 0; line < transfers.lines; ++line) {
        const std::array<Complex, 16> back =
            pem::at_frequency(own, transfers.from_hz + static_cast<double>(line) * transfers.step_hz);
        Complex* row = result.values.data() + line * channels * 4;
        for (std::size_t c = 0; c < channels; ++c)
            for (std::size_t j = 0; j < 4; ++j)
                for (std::size_t i = 0; i < 4; ++i) row[c * 4 + j] += transfers.at(line)[c * 4 + i] * back[i * 4 + j];
    }
    return result;
}

void for_each_felt(const pem::WheelTransfers& transfers, const std::vector<pem::FeltOrder>& felt,
                   const pem::DelayedSpectrum& source, const std::vector<double>& wheels, double speed, double bin_hz,
                   const ExpectedSpectra& expected,
                   const std::function<void(std::size_t, double, const std::vector<Complex>&)>& take) {
    const std::size_t size = expected.channels;
    std::vector<Complex> at(size * 4), y(size);
    for (std::size_t b = 0; b < expected.bins() && felt.size() > 1; ++b) {
        const double f = static_cast<double>(expected.first_bin + b) * bin_hz;
        pem::interpolate(transfers, f, at.data());
        for (std::size_t order = 1; order < felt.size(); ++order) {
            const std::array<Complex, 4> e = pem::felt_irregularity(felt, order, source, wheels, speed, f);
            for (std::size_t c = 0; c < size; ++c)
                y[c] = at[c * 4] * e[0] + at[c * 4 + 1] * e[1] + at[c * 4 + 2] * e[2] + at[c * 4 + 3] * e[3];
            take(b, std::abs(f - felt[order].shift_hz), y);
        }
    }
}

void add_felt(const pem::WheelTransfers& transfers, const std::vector<pem::FeltOrder>& felt,
              const pem::DelayedSpectrum& source, const std::vector<double>& wheels, double speed, double bin_hz,
              ExpectedSpectra& expected) {
    const std::size_t size = expected.channels;
    for_each_felt(transfers, felt, source, wheels, speed, bin_hz, expected,
                  [&](std::size_t b, double, const std::vector<Complex>& y) {
                      add_outer_product(y, expected.values.data() + b * size * size);
                  });
}

namespace {

/// Adds a share of a line's power where it stands, a Gaussian of `deviation` Hz (five-point Gauss–Hermite rule).
void add_line(const pem::WheelTransfers& transfers, const pem::SpectralLine& line, double frequency, double deviation,
              double share, const recordings::WindowKernel& kernel, ExpectedSpectra& expected) {
    constexpr double kNodes[5] = {-2.8569700138728, -1.3556261799742, 0.0, 1.3556261799742, 2.8569700138728};
    constexpr double kWeights[5] = {0.0112574113277, 0.2220759220056, 0.5333333333333, 0.2220759220056,
                                    0.0112574113277};
    const double bin = kernel.bin_hz();
    const std::size_t size = expected.channels;
    const double first = static_cast<double>(expected.first_bin) * bin;
    const double last = static_cast<double>(expected.first_bin + expected.bins()) * bin;
    const double reach =
        kExpectationSettings.kernel_reach_bins * bin + kExpectationSettings.line_reach_deviations * deviation;
    if (frequency < first - reach || frequency > last + reach) return;
    std::vector<Complex> at(size * 4);
    pem::interpolate(transfers, frequency, at.data());
    Eigen::VectorXcd response = Eigen::VectorXcd::Zero(static_cast<long>(size));
    for (std::size_t c = 0; c < size; ++c)
        for (std::size_t j = 0; j < 4; ++j) response(static_cast<long>(c)) += at[c * 4 + j] * line.amplitude_m[j];
    const Eigen::MatrixXcd power = 0.5 * share * response * response.adjoint();
    for (std::size_t b = 0; b < expected.bins(); ++b) {
        const double distance = static_cast<double>(expected.first_bin + b) * bin - frequency;
        if (std::abs(distance) > reach) continue;
        double density = 0.0;
        for (int k = 0; k < 5; ++k) density += kWeights[k] * kernel(distance - kNodes[k] * deviation);
        expected.matrix(b) += density * power;
    }
}

}  // namespace

void add_lines(const pem::CaseParameters& parameters, const pem::WheelTransfers& transfers, const pem::LineSet& set,
               const recordings::WindowKernel& kernel, const SpeedMixture* speeds, ExpectedSpectra& expected) {
    const std::vector<double> one_speed(1, 0.0);
    const std::vector<double>& nodes = speeds ? speeds->nodes() : one_speed;
    for (const pem::SpectralLine& line : set.lines)
        for (const double deviation : nodes) {
            const double frequency = line.frequency_hz / (1.0 + deviation);
            add_line(transfers, line, frequency, parameters.running.speed_fluctuation * frequency,
                     1.0 / static_cast<double>(nodes.size()), kernel, expected);
        }
}

void add_sensor_noise(const pem::CaseParameters& parameters, const std::vector<ObservedChannel>& channels,
                      double bin_hz, ExpectedSpectra& expected) {
    for (const pem::SensorParameters& sensor : parameters.sensors)
        for (std::size_t c = 0; c < channels.size() && sensor.noise_rms_m_per_s2 > 0.0; ++c) {
            if (pem::measured_response(sensor.channel) != pem::response_names()[channels[c].response].where) continue;
            for (std::size_t b = 0; b < expected.bins(); ++b)
                expected.matrix(b)(static_cast<long>(c), static_cast<long>(c)) +=
                    pem::sensor_noise_psd(sensor, static_cast<double>(expected.first_bin + b) * bin_hz);
        }
}

}  // namespace railpem::diagnosis
