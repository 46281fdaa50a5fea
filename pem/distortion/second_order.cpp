#include "pem/distortion/second_order.hpp"

#include <algorithm>
#include <memory>
#include <unsupported/Eigen/FFT>
#include <utility>

namespace railpem::pem {

namespace {

using Phasor = std::complex<double>;

/// Two-sided cross-spectra of the response under every two wheels, i ≤ j, as each meets the track: the delays between
/// them taken off. At k·kSquareStep_hz, k = 0 (nothing) on.
std::array<std::vector<Phasor>, kPairs> spectra_of_pairs(const SquareTransfers& transfers,
                                                         const std::vector<DelayedSpectrum>& broadband,
                                                         const std::vector<double>& wheels_m, double speed) {
    std::array<std::vector<Phasor>, kPairs> pairs;
    for (auto& own : pairs) own.assign(transfers.size() + 1, 0.0);
    for (std::size_t line = 0; line < transfers.size(); ++line) {
        const double f = static_cast<double>(line + 1) * kSquareStep_hz;
        std::array<Phasor, 4> delay;
        for (std::size_t j = 0; j < 4; ++j) delay[j] = delay_phase(wheels_m, j, f, speed);
        for (const DelayedSpectrum& source : broadband) {
            const std::array<Phasor, 4> e = met(source, wheels_m, speed, f);
            std::array<Phasor, 4> y{};
            for (std::size_t wheel = 0; wheel < 4; ++wheel) {
                for (std::size_t j = 0; j < 4; ++j) y[wheel] += transfers[line][wheel * 4 + j] * e[j];
                y[wheel] *= std::conj(delay[wheel]);
            }
            std::size_t pair = 0;
            for (std::size_t i = 0; i < 4; ++i)
                for (std::size_t j = i; j < 4; ++j) pairs[pair++][line + 1] += 0.5 * y[i] * std::conj(y[j]);
        }
    }
    return pairs;
}

}  // namespace

PairCorrelations pair_correlations(const SquareTransfers& transfers, const std::vector<DelayedSpectrum>& broadband,
                                   const std::vector<double>& wheels_m, double speed, int highest) {
    const auto pairs = spectra_of_pairs(transfers, broadband, wheels_m, speed);
    std::size_t size = 64;
    // the band of the highest power, and ours beside it: nothing wraps around
    while (size < static_cast<std::size_t>(highest + 2) * (transfers.size() + 1)) size *= 2;
    Eigen::FFT<double> transform;
    transform.SetFlag(Eigen::FFT<double>::HalfSpectrum);
    PairCorrelations result{.lines = transfers.size(), .at = {}};
    for (std::size_t pair = 0; pair < kPairs; ++pair) {
        std::vector<Phasor> half(pairs[pair]);
        half.resize(size / 2 + 1, 0.0);
        transform.inv(result.at[pair], half);
        for (double& own : result.at[pair]) own *= static_cast<double>(size) * kSquareStep_hz;
    }
    return result;
}

std::vector<std::vector<double>> contrasts_of_powers(const PairCorrelations& correlations, int power, double scale) {
    const std::size_t size = correlations.at.front().size();
    Eigen::FFT<double> transform;
    transform.SetFlag(Eigen::FFT<double>::HalfSpectrum);
    std::array<std::vector<double>, kContrasts.size()> sums;
    for (auto& own : sums) own.assign(size, 0.0);
    std::size_t pair = 0;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = i; j < 4; ++j, ++pair) {
            for (std::size_t t = 0; t < size; ++t) {
                double own = 1.0;
                for (int n = 0; n < power; ++n) own *= correlations.at[pair][t] / scale;
                for (std::size_t c = 0; c < sums.size(); ++c)
                    sums[c][t] += kContrasts[c][i] * kContrasts[c][j] / 16.0 * (i == j ? 1.0 : 2.0) * own;
            }
        }
    std::vector<std::vector<double>> result;
    for (const std::vector<double>& sum : sums) {
        std::vector<Phasor> half;
        transform.fwd(half, sum);
        std::vector<double> psd{0.0};  // twice the two-sided one
        for (std::size_t k = 1; k <= correlations.lines; ++k)
            psd.push_back(std::max(0.0, half[k].real()) * 2.0 / (static_cast<double>(size) * kSquareStep_hz));
        result.push_back(std::move(psd));
    }
    return result;
}

std::vector<std::vector<double>> contrasts_of_squares(const SquareTransfers& transfers,
                                                      const std::vector<DelayedSpectrum>& broadband,
                                                      const std::vector<double>& wheels_m, double speed) {
    std::vector<std::vector<double>> result =
        contrasts_of_powers(pair_correlations(transfers, broadband, wheels_m, speed, 2), 2, 1.0);
    for (std::vector<double>& psd : result)
        for (double& own : psd) own *= 2.0;
    return result;
}

DelayedSpectrum contrast_source(const char* name, std::size_t contrast, std::vector<double> power) {
    const auto shared = std::make_shared<const std::vector<double>>(std::move(power));
    const auto psd = [shared](double f) {
        const double place = f / kSquareStep_hz;
        const auto k = static_cast<std::size_t>(place);
        if (k + 1 >= shared->size()) return 0.0;
        const double share = place - static_cast<double>(k);
        return (1.0 - share) * (*shared)[k] + share * (*shared)[k + 1];
    };
    return {name, psd, kContrasts[contrast]};
}

}  // namespace railpem::pem
