#pragma once

#include <vector>

#include "parameters/field.hpp"

namespace railpem::track {

/// How a loss factor enters the pad. constant: K(1 + iη) at every frequency (not causal, usual in track models);
/// causal: K·(f/f_l)^{(2/π)·atan η}·(1 + iη), which *replaces* the dashpot.
enum class LossLaw { constant, causal };

/// The rail pads: static curve F(S), static and dynamic stiffness, frequency law.
///
/// Dynamic stiffness of pad j at frequency f (Wei et al. 2016, eqs. 10 and 11; Fenander 1997; Maes et al. 2006):
///   K0_j = ratio·[(1 − s)·K_secant + s·K(S_j)],  s = preload_strength
///   K_j(f) = K0_j·(f/f0)^k·[causal: 1 + i·tan(πk/2)]·[loss law] + iωc
/// Every law is multiplied onto K0_j, so all pads share one shape in frequency.
struct PadParameters {
    double static_stiffness_n_per_m = 0.0;  ///< K_secant, the constant static stiffness
    double dynamic_to_static_ratio = 1.0;   ///< 1.4 in the paper
    double preload_strength = 0.0;          ///< s: 0 constant stiffness, 1 stiffness from the static equilibrium
    double reference_frequency_hz = 4.0;    ///< f0
    double exponent = 0.0;                  ///< k
    bool causal = false;                    ///< multiply by 1 + i·tan(πk/2), the spring-pot
    double damping_n_s_per_m = 0.0;         ///< c, the dashpot beside the spring
    double loss_factor = 0.0;               ///< η
    LossLaw loss_law = LossLaw::causal;
    double loss_reference_hz = 30.0;  ///< f_l, causal loss law only

    /// Static curve: coefficients of F(S) = Σ c_i S^i in N with S in m (compression positive). Empty: linear with
    /// K_secant.
    std::vector<double> force_polynomial_n;
    /// Or as points: compression in m, force in N, increasing (monotone cubic between them). Excludes the polynomial.
    std::vector<double> curve_compression_m;
    std::vector<double> curve_force_n;
    double curve_limit_n = 90e3;  ///< force up to which the curve was measured; beyond it the tangent goes on

    /// Measured complex modulus relative to its value at f0: frequency, storage ratio, loss factor. Replaces exponent
    /// and loss.
    std::vector<double> table_frequency_hz;
    std::vector<double> table_storage_ratio;
    std::vector<double> table_loss_factor;
};

/// Fasteners that carry little or nothing. Every n-th seat (`every`), or a random share (`fraction`) drawn by `seed`;
/// what remains at those seats is `remaining_stiffness_fraction` of the pad's stiffness and damping.
struct FailedFasteners {
    int every = 0;  ///< 0: none; n ≥ 2: every n-th seat
    /// one of the regularly failed seats; seat 0 is the pad at or behind wheel 1, growing towards the front
    int first_seat = 0;
    double fraction = 0.0;  ///< share of random failed seats, 0: none
    double remaining_stiffness_fraction = 0.0;
    int seed = 1;
};

parameters::Fields<PadParameters> pad_fields();
parameters::Fields<FailedFasteners> failed_fastener_fields();

}  // namespace railpem::track
