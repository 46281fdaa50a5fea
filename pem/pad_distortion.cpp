#include "pem/pad_distortion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <memory>
#include <unsupported/Eigen/FFT>

#include "pem/angular_frequency.hpp"
#include "pem/solution.hpp"
#include "pem/wheel_transfers.hpp"
#include "track/pad_law.hpp"
#include "track/rolling_pads.hpp"

namespace railpem::pem {

namespace {

using Phasor = std::complex<double>;

constexpr double kStep_hz = 1.0;
constexpr int kRailEvery = 2;

/// At k·kStep_hz, k = 0 (nothing) on: two-sided spectra of the rail's displacement under wheels 1 and 2, m²/Hz, as each meets the track, the delay between
/// them taken off.
struct RailUnderBogie {
    std::vector<Phasor> leading{0.0}, trailing{0.0}, cross{0.0};
};

RailUnderBogie rail_under_bogie(const PadTransfers& transfers, const std::vector<DelayedSpectrum>& broadband, const std::vector<double>& wheels_m, double speed) {
    RailUnderBogie under;
    for (std::size_t line = 0; line < transfers.rail.size(); ++line) {
        const double f = static_cast<double>(line + 1) * kStep_hz;
        std::array<Phasor, 4> delay;
        for (std::size_t j = 0; j < 4; ++j) delay[j] = delay_phase(wheels_m, j, f, speed);
        Phasor leading = 0.0, trailing = 0.0, cross = 0.0;
        for (const DelayedSpectrum& source : broadband) {
            std::array<Phasor, 2> y;
            for (std::size_t wheel = 0; wheel < 2; ++wheel) {
                for (std::size_t j = 0; j < 4; ++j) y[wheel] += transfers.rail[line][wheel * 4 + j] * source.share[j] * delay[j];
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

/// ∫ S(f − g)·S(g) dg of leading + trailing − 2·cross at every line, S(−f) = conj S(f): squares of the correlations, and back.
std::vector<double> difference_of_squares(const RailUnderBogie& under) {
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
    std::vector<double> result;
    for (std::size_t k = 0; k < under.cross.size(); ++k) result.push_back(std::max(0.0, half[k].real()) * static_cast<double>(size) * kStep_hz);
    return result;
}

}  // namespace

PadTransfers pad_transfers(const CaseParameters& parameters, const CoupledModel& model, const PadTransfers* same_track) {
    if (parameters.track.pads.preload_strength <= 0.0) return {};
    const auto lines = static_cast<std::size_t>(parameters.frequency.to_hz / kStep_hz);
    PadTransfers transfers;
    if (same_track) {
        transfers.force_per_m2 = same_track->force_per_m2;
        transfers.rails = same_track->rails;
    } else {
        const track::LoadedDeflection loaded = track::loaded_deflection(parameters.track, wheel_load_n(parameters));
        transfers.force_per_m2 = 0.5 * loaded.curvature_m_per_n2 / std::pow(loaded.compliance_m_per_n, 3);
        transfers.rails = rail_groups(model, kStep_hz, kStep_hz, lines, kRailEvery, 1);
    }
    const WheelTransfers rail = wheel_transfers(model, kStep_hz, kStep_hz, lines, {response_index("rail_1"), response_index("rail_2")}, 1, &transfers.rails);
    for (std::size_t line = 0; line < lines; ++line) {
        const double f = static_cast<double>(line + 1) * kStep_hz, omega = kTwoPi * f;
        std::array<Phasor, 8> displacement;
        for (std::size_t i = 0; i < displacement.size(); ++i) displacement[i] = rail.at(line)[i] / (-omega * omega);
        transfers.rail.push_back(displacement);
        const Phasor receptance = transfers.rails[line / lanes::width].rail[0][0][static_cast<int>(line % lanes::width)];
        transfers.response2.push_back(std::norm(transfers.force_per_m2 * receptance * track::pad_shape(parameters.track.pads, f)));
    }
    return transfers;
}

std::vector<DelayedSpectrum> pad_distortion(const PadTransfers& transfers, const std::vector<DelayedSpectrum>& broadband, const std::vector<double>& wheels_m, double speed) {
    if (transfers.rail.empty()) return {};
    const RailUnderBogie under = rail_under_bogie(transfers, broadband, wheels_m, speed);
    const std::vector<double> squares = difference_of_squares(under);
    const auto power = std::make_shared<std::vector<double>>(1, 0.0);
    // Twice the product of two-sided spectra is the cross-spectrum of the squares; twice that the one-sided one; a quarter of it that of half the difference.
    for (std::size_t k = 1; k < squares.size(); ++k) power->push_back(transfers.response2[k - 1] * squares[k]);
    const auto psd = [power](double f) {
        const double place = f / kStep_hz;
        const auto k = static_cast<std::size_t>(place);
        if (k + 1 >= power->size()) return 0.0;
        const double share = place - static_cast<double>(k);
        return (1.0 - share) * (*power)[k] + share * (*power)[k + 1];
    };
    return {{"pad_distortion", psd, {1.0, -1.0, 1.0, -1.0}}};
}

}  // namespace railpem::pem
