#pragma once
// A stretch of rail without supports as an exact dynamic stiffness between its two ends.

#include <vector>

#include "lanes/complex_lanes.hpp"
#include "lanes/factor_curve.hpp"
#include "track/rail_parameters.hpp"

namespace railpem::track {

/// The beam at one frequency per lane.
struct BeamCoefficients {
    lanes::Complex bending;           ///< B = EI(1 + iη), N·m²
    lanes::Complex shear_compliance;  ///< s = 1/(κGA(1 + iη)), 1/N; 0 for Euler
    lanes::Real rotary;               ///< r = ω²ρI, N; 0 for Euler
    lanes::Complex inertia;           ///< μ = ω²·(m + dampers)·factor, N/m²
};

/// ω in rad/s, one per lane. Rail dampers add their dynamic mass to μ. `mass_factor`: TrackModifiers::rail.
BeamCoefficients beam_coefficients(const RailParameters& rail, const std::vector<RailDamper>& dampers,
                                   lanes::Real omega, const lanes::FactorCurve& mass_factor = {});

/// D(k) = Sk²(Bk² − r)/(Bk² + S − r) − μ with S = 1/s (Euler: Bk⁴ − μ): force per metre of the free rail for a unit
/// wave e^{ikx}, N/m².
lanes::Complex beam_stiffness(const BeamCoefficients& beam, lanes::Real wavenumber_per_m);

/// Dynamic stiffness of a stretch between nodes 0 and 1 with displacements (w, ψ), ψ the rotation of the section:
/// [F0; F1] = [near, far; farᵀ, mirrored(near)]·[d0; d1].
struct RailElement {
    lanes::Matrix2 near;
    lanes::Matrix2 far;
};

/// Seen from the other end: sign of the coupling between displacement and rotation changes.
lanes::Matrix2 mirrored(const lanes::Matrix2& block);

/// Exact element of length ℓ > 0.
///
/// State y = (w, ψ, M, Q): w' = ψ + sQ, ψ' = M/B, M' = −Q − rψ, Q' = −μw, so y(ℓ) = exp(Aℓ)·y(0). The wavenumbers obey
/// λ⁴ = pλ² + q with p = −(r/B + sμ), q = μ(1 − sr)/B, hence exp(Aℓ) = C0 + C1·A + C2·A² + C3·A³ with four entire
/// functions of pℓ² and qℓ⁴, summed as power series: no root is taken, nothing cancels at low frequency, and Euler
/// and Timoshenko are one formula. Long stretches or high frequencies are halved until the series is short
/// (|λℓ| ≤ 2) and doubled again by condensation, which is stable.
RailElement rail_element(const BeamCoefficients& beam, double length_m);

}  // namespace railpem::track
