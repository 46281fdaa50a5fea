#pragma once

#include <vector>

namespace railpem::track {

/// A spring-pot E(f) = E_ref·(f/f_ref)^k·(1 + i·tan(πk/2)) fitted to a measured complex modulus, and how well it fits.
struct PowerLawFit {
    double storage_at_reference = 0.0;   ///< E_ref, in the unit of the storage modulus
    double exponent = 0.0;               ///< k
    double rms_error_db = 0.0;           ///< of the modulus |E|, measured over fitted
    double largest_error_db = 0.0;       ///< its largest absolute value
    double rms_loss_factor_error = 0.0;  ///< measured minus tan(πk/2)
};

/// Least squares of the complex logarithm, every point with the same weight. A spring-pot is ln E = a + k·(ln f +
/// iπ/2), a straight line with one slope for modulus and phase, so the fit is in closed form:
///   k = [Σ (x − x̄)(y − ȳ) + (π/2)·Σ φ] / [Σ (x − x̄)² + n·(π/2)²],  x = ln f, y = ln|E|, φ = atan η.
/// `frequency_hz`, `storage` > 0, `loss_factor` ≥ 0: of the same length, at least two points of different frequency.
PowerLawFit fit_power_law(const std::vector<double>& frequency_hz, const std::vector<double>& storage,
                          const std::vector<double>& loss_factor, double reference_hz);

}  // namespace railpem::track
