#pragma once
// What a train feels of its supports: the deflection under the standing load differs from place to place.

#include <functional>
#include <vector>

#include "pem/case_parameters.hpp"
#include "pem/coupling/excitation.hpp"
#include "track/statics/rolling_pads.hpp"

namespace railpem::pem {

/// Lines at m·v/(n·spacing), n = 1 or the period of failed fasteners: the deflection of the rail under the wheel loads
/// is periodic along the track and acts like an irregularity. On sound fasteners it is that under rolling wheels
/// (track::rolling_deflection()). Where some have failed it is that under standing loads, r(x) = −P0·Σ_j C_ij(x). C is
/// the receptance with the wheels shifted by x, taken at half the frequency of the line: between that of the load, 0,
/// and that at which it is felt (the symbol of Weyl). At the line's own the first six lines of a marched record were
/// 0.5 % too small to 4.8 % too large, so they are 0.1 to 1.4 % too small (Modulation.LinesOfFailedFasteners). Scaled
/// by sleeper_passing.amplitude_factor for the lines of the intact bays, on sound fasteners by no more than
/// own_passing(); lines that only the failed fasteners cause are always in. Empty when there is nothing to feel.
/// `rolling`: RailModel::constant_loads() of the case, where it is known.
std::vector<SpectralLine> passing_lines(const CaseParameters& parameters, const std::vector<double>& wheels_m,
                                        double speed_m_per_s, const track::PadHistory* rolling = nullptr);

/// The share of sleeper_passing.amplitude_factor that is the track's own compliance under rolling wheels, and what is
/// in excess of it: an irregularity like the deflection under standing loads, alike at every speed and under the wheels
/// of a bogie, where that under rolling wheels is not (at 38 m/s it differs by 5 %, from wheel to wheel by 1 %).
double own_passing(const CaseParameters& parameters);
double excess_passing(const CaseParameters& parameters);

/// Lines of an excess of 1, on sound fasteners.
std::vector<SpectralLine> unit_excess_lines(const CaseParameters& parameters, const std::vector<double>& wheels_m,
                                            double speed_m_per_s);

/// Random failed fasteners: each changes the deflection under every wheel by a pulse c_i(x), and N = share/spacing of
/// them per metre, independently placed, are shot noise: √(2·p(1 − p)/spacing/v)·∫ c_i(x) e^{−iκx} dx under wheel i, κ
/// = 2πf/v, one-sided, m/√Hz, delays included. The pulse is −P0·(C with one seat failed − C intact) on the otherwise
/// uniform track: a seat that fails under one wheel is felt by its neighbour, ahead of it or behind. Null without
/// random failures.
std::function<std::array<std::complex<double>, 4>(double)> failed_fastener_amplitudes(
    const CaseParameters& parameters, const std::vector<double>& wheels_m, double speed_m_per_s);

}  // namespace railpem::pem
