#pragma once
// What the motion of the wheels along the rail changes in the rail's receptance.

#include <complex>
#include <vector>

#include "track/exact_rail.hpp"

namespace railpem::track {

/// R(v) − R(0) in m/N at a distance: observed point ahead of the force (in the direction of travel), and behind it.
struct ConvectedChange {
    std::complex<double> ahead;
    std::complex<double> behind;
};

/// Most distances that one call takes; four wheels have at most six and zero.
inline constexpr std::size_t kMostDistances = 8;

/// Changes R(v) − R(0) of the receptances between points that move along the rail at speed v, for the track with its
/// supports smeared over the spacing; into `change`, one per distance.
///
/// In the frame of the wheels the rail obeys its equation with ∂t → ∂t − v∂x:
///   R_v(x) = 1/2π ∫ e^{ikx}/D(ω − kv, k) dk,  D(ω', k) = Sk²(Bk² − r')/(Bk² + S − r') − μ(ω') + K(ω')/spacing
/// (Euler: Bk⁴ − μ + K/spacing), r' = ω'²ρI, μ = ω'²(m + dampers), K(−ω') = conj K(ω').
/// `distances_m` ≥ 0, at most kMostDistances (R(v) is not symmetric). `pad_stiffness_n_per_m`: K0 of the pads around the wheels.
///
/// Trapezoidal rule, which converges exponentially: its step keeps the periodic images of the slowest wave below 1e-7, what lies beyond
/// its reach is added by Gauss points in 1/k. Laws whose loss is no odd polynomial of ω' break at ω' = 0, k = ω/v; where that lies
/// among the waves of the rail the points gather there. For v = 0 exactly zero. v ≥ 0 and below the critical speed; ω > 0.
void convected_change(const ExactRail& rail, double pad_stiffness_n_per_m, double omega, double speed_m_per_s,
                      const std::vector<double>& distances_m, ConvectedChange* change);

}  // namespace railpem::track
