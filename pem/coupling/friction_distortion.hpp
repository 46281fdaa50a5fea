#pragma once
// What dry friction does beyond its equivalent damping.

#include <complex>
#include <cstddef>
#include <vector>

namespace railpem::pem {

/// Cross-spectra of the velocities across the elements of one stage, one-sided, (m/s)²/Hz, at from_hz + i·step_hz.
struct VelocitySpectra {
    double from_hz = 0.0, step_hz = 1.0;
    std::size_t elements = 0, lines = 0;
    std::vector<std::complex<double>> values;  ///< [line][row][column]
};

/// Cross-spectra of the forces F·sgn(v_i) without their linear part, one-sided, N²/Hz, on the same lines.
///
/// Of Gaussian velocities with correlation ρ_ij(τ) the forces F·sgn have the correlation F²·(2/π)·asin ρ_ij(τ) (van
/// Vleck & Middleton 1966, Proc. IEEE 54, eq. 17). The equivalent damper c = F·√(2/π)/σ carries F²·(2/π)·ρ_ij(τ) of it;
/// the rest is uncorrelated with every velocity (Bussgang 1952) and acts as a source inside the suspension, with up to
/// 1 − 2/π of the force's power. Without correction for its own effect on the velocities: right while the equivalent
/// damping is.
std::vector<std::complex<double>> friction_distortion(const VelocitySpectra& velocity, double force_n);

}  // namespace railpem::pem
