#pragma once
// Track decay rate: how fast vibration dies away along the rail.

#include <complex>
#include <vector>

namespace railpem::track {

/// Distances from the force at which EN 15461:2008 asks for transfer functions, in m: force in the middle of a bay,
/// response every quarter of a bay at first, ever more widely up to 66 bays.
std::vector<double> decay_rate_positions_m(double spacing_m);

/// Decay rate of EN 15461 in dB/m: 4.343/Σ_n (|A(x_n)|²/|A(x_0)|²)·Δx_n, Δx_n the length that point n stands for (half
/// the distance to each neighbour; the first and the last point to one side). `squared`: |A(x_n)|², averaged over the
/// band.
double decay_rate_db_per_m(const std::vector<double>& positions_m, const std::vector<double>& squared);

/// Decay of the far-reaching Bloch wave, −20·log10|λ|/spacing in dB/m, λ its factor per bay.
double bloch_decay_rate_db_per_m(std::complex<double> factor_1, std::complex<double> factor_2, double spacing_m);

}  // namespace railpem::track
