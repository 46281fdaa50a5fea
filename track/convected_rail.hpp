#pragma once
// What the motion of the wheels along the rail changes in the rail's receptance.

#include <complex>
#include <vector>

#include "track/exact_rail.hpp"

namespace railpem::track {

/// Change R(v) − R(0) of the receptances between points that move along the rail at speed v, in m/N, for the track with its
/// supports smeared over the spacing.
///
/// In the frame of the wheels the rail obeys its equation with ∂t → ∂t − v∂x:
///   R_v(x) = 1/2π ∫ e^{ikx}/D(ω − kv, k) dk,  D(ω', k) = Sk²(Bk² − r')/(Bk² + S − r') − μ(ω') + K(ω')/spacing
/// (Euler: Bk⁴ − μ + K/spacing), r' = ω'²ρI, μ = ω'²(m + dampers), K(−ω') = conj K(ω').
/// `separations_m`: x_i − x_j (observed minus forced, positive: the observed point runs ahead), signed: R(v) is not symmetric.
/// `pad_stiffness_n_per_m`: K0 of the pads around the wheels.
///
/// Trapezoidal rule; its step keeps the periodic images e^{−s(2π/h − x)} of the slowest wave below 1e-9 (s: its decay per
/// metre), its reach leaves out less than 1e-5 of the change. For v = 0 exactly zero. v ≥ 0 and below the critical speed.
std::vector<std::complex<double>> convected_change(const ExactRail& rail, double pad_stiffness_n_per_m, double omega, double speed_m_per_s,
                                                   const std::vector<double>& separations_m);

}  // namespace railpem::track
