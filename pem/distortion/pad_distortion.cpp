#include "pem/distortion/pad_distortion.hpp"

#include <array>
#include <cmath>
#include <complex>

#include "pem/angular_frequency.hpp"
#include "pem/coupling/wheel_transfers.hpp"
#include "pem/distortion/second_order.hpp"
#include "pem/response_names.hpp"
#include "track/pads/pad_law.hpp"
#include "track/statics/rolling_pads.hpp"

namespace railpem::pem {

namespace {

using Phasor = std::complex<double>;

}  // namespace

PadTransfers pad_transfers(const CaseParameters& parameters, const CoupledModel& model,
                           const PadTransfers* same_track) {
    if (parameters.track.pads.preload_strength <= 0.0) return {};
    const auto lines = static_cast<std::size_t>(parameters.frequency.to_hz / kSquareStep_hz);
    PadTransfers transfers;
    if (same_track) {
        transfers.force_per_m2 = same_track->force_per_m2;
        transfers.rails = same_track->rails;
    } else {
        const track::LoadedDeflection loaded = track::loaded_deflection(parameters.track, wheel_load_n(parameters));
        transfers.force_per_m2 = 0.5 * loaded.curvature_m_per_n2 / std::pow(loaded.compliance_m_per_n, 3);
        transfers.rails = rail_groups(model, kSquareStep_hz, kSquareStep_hz, lines, kSquareRailEvery, 1);
    }
    const WheelTransfers rail = wheel_transfers(
        model, kSquareStep_hz, kSquareStep_hz, lines,
        {response_index("rail_1"), response_index("rail_2"), response_index("rail_3"), response_index("rail_4")}, 1,
        &transfers.rails);
    for (std::size_t line = 0; line < lines; ++line) {
        const double f = static_cast<double>(line + 1) * kSquareStep_hz, omega = kTwoPi * f;
        std::array<Phasor, 16> displacement;
        for (std::size_t i = 0; i < displacement.size(); ++i) displacement[i] = rail.at(line)[i] / (-omega * omega);
        transfers.rail.push_back(displacement);
        const Phasor receptance =
            transfers.rails[line / lanes::width].rail[0][0][static_cast<int>(line % lanes::width)];
        transfers.response2.push_back(
            std::norm(transfers.force_per_m2 * receptance * track::pad_shape(parameters.track.pads, f)));
    }
    return transfers;
}

std::vector<DelayedSpectrum> pad_distortion(const PadTransfers& transfers,
                                            const std::vector<DelayedSpectrum>& broadband,
                                            const std::vector<double>& wheels_m, double speed) {
    if (transfers.rail.empty()) return {};
    std::vector<DelayedSpectrum> sources;
    for (std::vector<double>& power : contrasts_of_squares(transfers.rail, broadband, wheels_m, speed)) {
        for (std::size_t k = 1; k < power.size(); ++k) power[k] *= transfers.response2[k - 1];
        sources.push_back(contrast_source("pad_distortion", sources.size(), std::move(power)));
    }
    return sources;
}

}  // namespace railpem::pem
