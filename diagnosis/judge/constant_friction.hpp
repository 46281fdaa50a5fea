#pragma once
// What a constant friction would seem to be to a fit whose friction is linearised.

#include <vector>

#include "diagnosis/fit/fit.hpp"

namespace railpem::diagnosis {

/// The unknown that stands for the power of friction's own forces, in multiples of what friction_distortion() gives,
/// less 1, believed within 1.
Unknown power_of_friction();

/// Derivatives of a fit's predictions with it; of no observation where there is no friction.
std::vector<PredictionDerivative> derivatives_with_power(const Fit& fit, const LikelihoodContext& context);

/// The recordings as they would be if `trial` were true and its friction a constant force, with what that does where
/// velocities are not Gaussian (pem::realised_friction): expected spectra, noise and floor included, in the place of
/// the measured ones of the context's part. Recordings without a vehicle stay.
std::vector<Observation> with_constant_friction(const Trial& trial, const LikelihoodContext& context);

/// The power that a constant force would seem to have, to first order, in a fit that ended as this one did.
/// Linearisation takes a strong force for a stronger one beside another damper: the case whose realised recordings
/// would be fitted like this is found by one step from the fit.
double power_of_constant(const Fit& fit, const LikelihoodContext& context,
                         const std::vector<PredictionDerivative>& with_power);

}  // namespace railpem::diagnosis
