#pragma once
// How uncertain a fit's unknowns are where the model is not quite right.

#include <Eigen/Core>

#include "diagnosis/fit/fit.hpp"

namespace railpem::diagnosis {

/// Covariance of a fit's unknowns that does not take the model for exact: C(Σ g_b g_bᵀ + D⁻²)C with C = (F + D⁻²)⁻¹,
/// g_b what a third octave of one recording adds to the gradient of the log-likelihood. Where the model is right, Σ g_b
/// g_bᵀ is F on average and this is C; where it is not, bands pull the unknowns in different ways, by more than chance,
/// and this is what they disagree by (Huber 1967, Proc. 5th Berkeley Symp.; White 1982, Econometrica 50, eq. 3.2;
/// clusters: Liang & Zeger 1986, Biometrika 73). What all bands agree on it does not see. No deviation is smaller than
/// C's own: with some sixty bands the scatter is known to a tenth. C for recordings without time series. What all bands
/// agree on is added where it was found out: an effect's parameter that is `inexact` has that relative deviation beside
/// the rest.
Eigen::MatrixXd robust_covariance(const Fit& fit, const LikelihoodContext& context);

/// What an effect's law gets wrong of a parameter, as a deviation in its coordinate: EffectParameter::inexact, at least
/// `least` of the value.
double law_deviation(const EffectParameter& parameter, double coordinate, double least = 0.0);

}  // namespace railpem::diagnosis
