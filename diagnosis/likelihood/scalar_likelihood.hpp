#pragma once
// The likelihood of scalar recordings: Gaussian in the logarithm.

#include "diagnosis/likelihood/likelihood_context.hpp"

namespace railpem::diagnosis {

/// Whether a value belongs to a part of its recording.
bool belongs(const ScalarValue& value, Part part);

/// Values of all scalar recordings in a part.
std::size_t scalar_count(const std::vector<Observation>& observations, Part part);

/// Variance of the logarithm: that of the value, plus its discrepancy. `sharing` values of a twelfth of an octave have
/// one discrepancy in common, so their mean is known no better than it: σ² + n·δ².
double scalar_variance(const ScalarValue& value, double discrepancy, double least_floor = 0.0);

/// Log-likelihood of all scalar recordings relative to the saturated model: −½Σ[r²/s² + log(s²/σ²)], r =
/// log(model/measured).
double scalar_log_likelihood(const Trial& trial, const Predictions& predictions, const LikelihoodContext& context);

/// Adds log-likelihood, gradient and Fisher information (both triangles) of all scalar recordings.
void add_scalar_slope(const Trial& trial, const std::vector<Unknown>& unknowns, const Predictions& predictions,
                      const std::vector<PredictionDerivative>& derivatives, const LikelihoodContext& context,
                      LikelihoodSlope& slope);

/// dB per unit of the natural logarithm of a recording's values: 20 lg of amplitudes, 10 lg of powers and decay rates.
double db_per_neper(recordings::RecordingKind kind);

}  // namespace railpem::diagnosis
