#pragma once
// How the stiffness of a pad depends on frequency.

#include <complex>

#include "lanes/complex_lanes.hpp"
#include "track/pad_parameters.hpp"

namespace railpem::track {

/// The complex shape of the pad in frequency, common to all pads: K_j(f) = K0_j·shape(f) + i·2πf·pad_damping(). f > 0,
/// in Hz. TrackModifiers::pads is on K_j(f) and hence neither here nor in pad_damping().
///   power law     (f/f0)^k: Wei et al. 2016, eq. (10). Real, hence not causal together with a dashpot.
///   spring-pot    (f/f0)^k·(1 + i·tan(πk/2)) if `causal`: the companion that obeys Kramers and Kronig; Fenander 1997.
///   constant loss ×(1 + iη), usual in track models and not causal either.
///   causal loss   ×(f/f_l)^{(2/π)·atan η}·(1 + iη): the spring-pot whose loss factor is η; it replaces the dashpot.
///   table         storage ratio·(1 + i·loss factor) instead of all of these; storage linear in log-log, loss factor
///   linear
///                 over log f, both constant beyond the ends of the table.
std::complex<double> pad_shape(const PadParameters& pads, double frequency_hz);

/// The same for a group of frequencies.
lanes::Complex pad_shape(const PadParameters& pads, lanes::Real frequency_hz);

/// The dashpot beside the spring, N·s/m: 0 where the causal loss law has taken its place.
double pad_damping(const PadParameters& pads);

/// K0 = ratio·[(1 − s)·K_secant + s·K(S)] of a pad whose static stiffness is K(S), N/m, cut at zero: with s > 1 the law
/// would give unloaded pads a negative stiffness.
double initial_dynamic_stiffness(const PadParameters& pads, double static_stiffness_n_per_m);

}  // namespace railpem::track
