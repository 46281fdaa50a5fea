#pragma once
// The static force-compression curve of a pad, F(S).

#include <limits>
#include <vector>

#include "track/pad_parameters.hpp"

namespace railpem::track {

/// One cubic of the curve: F = c0 + c1·t + c2·t² + c3·t³ with t = S − from_m.
struct CurvePiece {
    double from_m = 0.0;
    double c0 = 0.0, c1 = 0.0, c2 = 0.0, c3 = 0.0;
};

/// F(S) in N over the compression S in m, continuous and never falling:
///   S ≤ free_compression_m:  F = 0, K = 0; rail and pad have parted, a pad carries no tension
///   up to limit_compression_m: the measured curve, F > 0 and K > 0
///   beyond it:               the tangent at the limit goes on
/// The clip preload is no part of it: clips are soft, and press on the rail with a constant force whatever S is.
struct PadCurve {
    std::vector<double> polynomial_n;  ///< coefficients c_i of F = Σ c_i S^i; empty: `pieces` hold the curve
    std::vector<CurvePiece> pieces;    ///< in order of from_m
    double free_compression_m = 0.0;   ///< where F passes through zero
    double limit_compression_m = std::numeric_limits<double>::infinity();  ///< end of the measured curve
    double limit_force_n = std::numeric_limits<double>::infinity();        ///< F there
    double limit_stiffness_n_per_m = 0.0;                                  ///< slope beyond it
};

/// The curve of the parameters: the polynomial (Wei et al. 2016, eq. 2), or the points joined by a monotone cubic
/// (Fritsch & Butland 1984, SIAM J. Sci. Stat. Comput. 5), or the line F = K_secant·S when neither is given (no limit
/// then). It ends at curve_limit_n, or at the last point if that is lower; points that begin at a positive force are
/// continued downwards by their first tangent. Throws parameters::ParameterError when the curve never passes through
/// zero force, falls before its limit, or never reaches it.
PadCurve pad_curve(const PadParameters& pads);

/// F(S), N.
double pad_force(const PadCurve& curve, double compression_m);
/// The same of compressions that change by little from call to call: `piece` is that of the last one, any number at
/// first.
double pad_force(const PadCurve& curve, double compression_m, std::size_t& piece);
/// K(S) = dF/dS, N/m; at the corners of the definition above the value towards smaller compression.
double pad_stiffness(const PadCurve& curve, double compression_m);
/// The compression at which the pad carries `force_n` > 0; accurate to rounding. Zero gives free_compression_m.
double pad_compression(const PadCurve& curve, double force_n);

}  // namespace railpem::track
