#pragma once
// What lies below the pads, and the whole seat: pad and support in series.

#include <complex>

#include "lanes/complex_lanes.hpp"
#include "lanes/factor_curve.hpp"
#include "track/support_parameters.hpp"

namespace railpem::track {

/// Displacement of the ground of the pad for a unit force from the pad, m/N, at f > 0 Hz: 0 on rigid ground, otherwise
/// that of the mass on its spring and of the sleeper's bending modes, as stated at SupportParameters (Knothe & Grassie
/// 1993). `factor`: TrackModifiers::support.
std::complex<double> support_receptance(const SupportParameters& support, double frequency_hz,
                                        const lanes::FactorCurve& factor = {});

/// The same for a group of frequencies, given as ω in rad/s.
lanes::Complex support_receptance(const SupportParameters& support, lanes::Real omega,
                                  const lanes::FactorCurve& factor = {});

/// The same at rest, m/N: springs only, no loss.
double static_support_compliance(const SupportParameters& support);

/// Stiffness from rail to ground of one seat: the pad in series with what is below it, N/m. A pad of zero stiffness
/// gives zero.
std::complex<double> support_stiffness(std::complex<double> pad_stiffness_n_per_m,
                                       std::complex<double> below_pad_m_per_n);

}  // namespace railpem::track
