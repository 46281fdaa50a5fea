#pragma once
// Dry friction as it is where velocities are not Gaussian: realised in time, without linearising it.

#include <cstdint>
#include <vector>

#include "lanes/factor_curve.hpp"
#include "pem/coupling/friction_distortion.hpp"
#include "pem/coupling/inner_transfers.hpp"

namespace railpem::pem {

/// What constant friction does that its linearisation c = F·√(2/π)/σ and friction_distortion() do not have. Its force
/// is c·v + damping·c·v_0 + rest, v the velocity across the element and v_0 the part of it that the track excites in
/// the linearised model; the rest has nothing to do with v_0.
struct RealisedFriction {
    lanes::FactorCurve damping;  ///< 0 where velocities are Gaussian
    lanes::FactorCurve power;    ///< of the rest, over friction_distortion(): 1 there
};

/// How it is realised.
struct RealisationOptions {
    int realisations = 100;
    int most_iterations = 400;
    double settled = 3e-3;  ///< of rms velocities
    std::uint32_t seed = 1;
};

/// Periodic realisations of a Gaussian excitation, in which the forces F·sgn(v) and the linear rest of vehicle and
/// track are brought to agree, sticking included, by Douglas–Rachford splitting (Lions & Mercier 1979, SIAM J. Numer.
/// Anal. 16): both are monotone, so that it converges. Over all elements of a stage, in third octaves of at least six
/// lines. `velocity`: velocity_spectra() of the linearised model; `transfers`: its element_transfers() on the same
/// lines; `damping`: c of every element, N·s/m; `force_n` > 0. The same seed gives the same curves.
RealisedFriction realised_friction(const VelocitySpectra& velocity, const ElementTransfers& transfers,
                                   const std::vector<double>& damping, double force_n,
                                   const RealisationOptions& options = {});

}  // namespace railpem::pem
