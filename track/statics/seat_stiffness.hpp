#pragma once
// The dynamic stiffness of the seats, as every rail solution takes it.

#include <Eigen/Core>
#include <complex>

#include "track/statics/static_equilibrium.hpp"
#include "track/track_modifiers.hpp"

namespace railpem::track {

/// Complex stiffness of one seat from rail to ground at f > 0 Hz, N/m: remaining_fraction·(K0·shape(f) + i·2πf·c),
/// times the pads' factor, in series with the support. `dynamic_stiffness_n_per_m`: K0.
std::complex<double> seat_stiffness(const TrackParameters& track, double dynamic_stiffness_n_per_m,
                                    double remaining_fraction, double frequency_hz,
                                    const TrackModifiers& modifiers = {});

/// The same for all pads of an equilibrium, in their order.
Eigen::VectorXcd seat_stiffness(const TrackParameters& track, const StaticEquilibrium& equilibrium, double frequency_hz,
                                const TrackModifiers& modifiers = {});

}  // namespace railpem::track
