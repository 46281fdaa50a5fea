#include "diagnosis/expectation/faint_sources.hpp"

#include <algorithm>
#include <array>

#include "diagnosis/expectation/delay_phases.hpp"
#include "lanes/complex_lanes.hpp"

namespace railpem::diagnosis {

using Complex = std::complex<double>;

namespace {

/// Power that four wheels meet together, real: Σ over sources of power·share·shareᵀ.
using Met = std::array<std::array<double, 4>, 4>;

std::vector<Met> met_together(const std::vector<pem::DelayedSpectrum>& sources, const FineGrid& grid) {
    std::vector<Met> met(grid.count, Met{});
    for (const pem::DelayedSpectrum& source : sources) {
        const std::vector<double> power = powers_at_lines(source, grid);
        for (std::size_t line = 0; line < grid.count; ++line)
            for (std::size_t i = 0; i < 4; ++i)
                for (std::size_t j = 0; j < 4; ++j) met[line][i][j] += power[line] * source.share[i] * source.share[j];
    }
    return met;
}

/// A row for every wheel, channels side by side, filled up to whole lanes.
struct ByWheel {
    explicit ByWheel(std::size_t channels)
        : stride((channels + lanes::width - 1) / lanes::width * lanes::width), re(4 * stride), im(4 * stride) {}
    std::size_t stride;
    std::vector<double> re, im;
};

/// T·M, M real.
void multiply(const ByWheel& transfer, const Met& met, ByWheel& product) {
    const std::size_t stride = transfer.stride;
    for (std::size_t j = 0; j < 4; ++j)
        for (std::size_t c = 0; c < stride; ++c) {
            double re = 0.0, im = 0.0;
            for (std::size_t i = 0; i < 4; ++i) {
                re += met[i][j] * transfer.re[i * stride + c];
                im += met[i][j] * transfer.im[i * stride + c];
            }
            product.re[j * stride + c] = re;
            product.im[j * stride + c] = im;
        }
}

/// Adds A·Bᴴ, Hermitian, column by column. `column` is room for one: its real parts, then its imaginary ones.
void add_product(const ByWheel& a, const ByWheel& b, std::size_t channels, std::vector<double>& column,
                 Complex* power) {
    const std::size_t stride = a.stride;
    double *re = column.data(), *im = re + stride;
    for (std::size_t k = 0; k < channels; ++k) {
        std::fill(column.begin(), column.end(), 0.0);
        for (std::size_t j = 0; j < 4; ++j) {
            const double *ar = &a.re[j * stride], *ai = &a.im[j * stride];
            const double br = b.re[j * stride + k], bi = b.im[j * stride + k];
#pragma omp simd
            for (std::size_t i = 0; i < stride; ++i) {
                re[i] += ar[i] * br + ai[i] * bi;
                im[i] += ai[i] * br - ar[i] * bi;
            }
        }
        power[k * channels + k] += re[k];
        for (std::size_t i = k + 1; i < channels; ++i) {
            power[k * channels + i] += Complex(re[i], im[i]);
            power[i * channels + k] += Complex(re[i], -im[i]);
        }
    }
}

}  // namespace

void add_as_they_are(const pem::WheelTransfers& transfers, const std::vector<pem::DelayedSpectrum>& sources,
                     const std::vector<double>& wheels, double speed, double bin_hz, ExpectedSpectra& expected) {
    const std::size_t bins = expected.bins(), channels = expected.channels;
    if (sources.empty()) return;
    const FineGrid at_bins{bin_hz, expected.first_bin, bins};
    const std::vector<Met> met = met_together(sources, at_bins);
    DelayPhases delays(wheels, speed, at_bins);
    std::vector<Complex> at(channels * 4);
    ByWheel transfer(channels), times_met(channels);
    std::vector<double> column(2 * transfer.stride);
    for (std::size_t b = 0; b < bins; ++b) {
        pem::interpolate(transfers, at_bins.frequency(b), at.data());
        const std::array<Complex, 4>& delay = delays.at(b);
        for (std::size_t j = 0; j < 4; ++j)
            for (std::size_t c = 0; c < channels; ++c) {
                const Complex t = at[c * 4 + j];
                transfer.re[j * transfer.stride + c] = t.real() * delay[j].real() - t.imag() * delay[j].imag();
                transfer.im[j * transfer.stride + c] = t.real() * delay[j].imag() + t.imag() * delay[j].real();
            }
        multiply(transfer, met[b], times_met);
        add_product(times_met, transfer, channels, column, expected.values.data() + b * channels * channels);
    }
}

void add_met_alone(const pem::CaseParameters& parameters, const pem::WheelTransfers& transfers,
                   const pem::DelayedSpectrum& source, const std::vector<double>& wheels, double speed, double bin_hz,
                   ExpectedSpectra& expected) {
    std::vector<pem::DelayedSpectrum> own(
        4, {.name = "met_alone",
            .psd_m2_per_hz =
                [&](double f) { return parameters.modifiers.share_met_alone(f, speed) * source.psd_m2_per_hz(f); },
            .share = {}});
    for (std::size_t wheel = 0; wheel < 4; ++wheel) own[wheel].share[wheel] = 1.0;
    add_as_they_are(transfers, own, wheels, speed, bin_hz, expected);
}

}  // namespace railpem::diagnosis
