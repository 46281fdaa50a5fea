#include "pem/second_order.hpp"

#include <algorithm>
#include <memory>
#include <unsupported/Eigen/FFT>
#include <utility>

namespace railpem::pem {

namespace {

using Phasor = std::complex<double>;

/// At k·kSquareStep_hz, k = 0 (nothing) on: two-sided spectra of the response under wheels 1 and 2, as each meets the track, the delay between them taken off.
struct UnderBogie {
    std::vector<Phasor> leading{0.0}, trailing{0.0}, cross{0.0};
};

UnderBogie under_bogie(const BogieTransfers& transfers, const std::vector<DelayedSpectrum>& broadband, const std::vector<double>& wheels_m, double speed) {
    UnderBogie under;
    for (std::size_t line = 0; line < transfers.size(); ++line) {
        const double f = static_cast<double>(line + 1) * kSquareStep_hz;
        std::array<Phasor, 4> delay;
        for (std::size_t j = 0; j < 4; ++j) delay[j] = delay_phase(wheels_m, j, f, speed);
        Phasor leading = 0.0, trailing = 0.0, cross = 0.0;
        for (const DelayedSpectrum& source : broadband) {
            std::array<Phasor, 2> y;
            for (std::size_t wheel = 0; wheel < 2; ++wheel) {
                for (std::size_t j = 0; j < 4; ++j) y[wheel] += transfers[line][wheel * 4 + j] * source.share[j] * delay[j];
                y[wheel] *= std::conj(delay[wheel]);
            }
            const double power = 0.5 * source.psd_m2_per_hz(f);
            leading += power * std::norm(y[0]);
            trailing += power * std::norm(y[1]);
            cross += power * y[0] * std::conj(y[1]);
        }
        under.leading.push_back(leading);
        under.trailing.push_back(trailing);
        under.cross.push_back(cross);
    }
    return under;
}

}  // namespace

std::vector<double> half_difference_of_squares(const BogieTransfers& transfers, const std::vector<DelayedSpectrum>& broadband, const std::vector<double>& wheels_m, double speed) {
    const UnderBogie under = under_bogie(transfers, broadband, wheels_m, speed);
    std::size_t size = 64;
    while (size < 4 * under.cross.size()) size *= 2;  // twice the band on both sides: nothing wraps around
    Eigen::FFT<double> transform;
    transform.SetFlag(Eigen::FFT<double>::HalfSpectrum);
    std::vector<double> sum(size, 0.0), correlation;
    for (const auto& [spectrum, weight] : {std::pair(&under.leading, 1.0), std::pair(&under.trailing, 1.0), std::pair(&under.cross, -2.0)}) {
        std::vector<Phasor> half(*spectrum);
        half.resize(size / 2 + 1, 0.0);
        transform.inv(correlation, half);
        for (std::size_t i = 0; i < size; ++i) sum[i] += weight * correlation[i] * correlation[i];
    }
    std::vector<Phasor> half;
    transform.fwd(half, sum);
    // Twice the product of two-sided spectra is the cross-spectrum of the squares; twice that the one-sided one; a quarter of it that of half the difference.
    std::vector<double> result{0.0};
    for (std::size_t k = 1; k < under.cross.size(); ++k) result.push_back(std::max(0.0, half[k].real()) * static_cast<double>(size) * kSquareStep_hz);
    return result;
}

DelayedSpectrum difference_source(const char* name, std::vector<double> power) {
    const auto shared = std::make_shared<const std::vector<double>>(std::move(power));
    const auto psd = [shared](double f) {
        const double place = f / kSquareStep_hz;
        const auto k = static_cast<std::size_t>(place);
        if (k + 1 >= shared->size()) return 0.0;
        const double share = place - static_cast<double>(k);
        return (1.0 - share) * (*shared)[k] + share * (*shared)[k + 1];
    };
    return {name, psd, {1.0, -1.0, 1.0, -1.0}};
}

}  // namespace railpem::pem
