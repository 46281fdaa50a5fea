#pragma once
// How well a trial explains the cross-spectral matrices, and how that changes with every unknown.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "diagnosis/likelihood/likelihood_context.hpp"

namespace railpem::diagnosis {

/// Prediction of one observation, `reuse` from the cache of a similar trial.
ExpectedSpectra predict_one(const Trial& trial, const LikelihoodContext& context, std::size_t observation,
                            const ExpectationCache* known = nullptr, Reuse reuse = Reuse::nothing,
                            ExpectationCache* filled = nullptr);

/// Predictions of a trial; observations in parallel.
Predictions predict(const Trial& trial, const LikelihoodContext& context);

/// Those of another part of the recordings than the `known` ones, which are of `context.part`: in it windows may have
/// been run at other speeds. `made` holds them where they are.
const Predictions& predictions_of(const Trial& trial, const Predictions& known, const LikelihoodContext& context,
                                  Part part, std::optional<Predictions>& made);

/// The same from what the predictions of a similar trial may share, as far as they have it.
ExpectedSpectra predict_like(const Predictions& similar, const Trial& trial, const LikelihoodContext& context,
                             std::size_t observation, Reuse reuse);

/// Log-likelihood of averaged cross-spectra (complex Wishart; Yuen, Katafygiotis & Beck 2002) relative to the saturated
/// model: −Σ n[log det S − log det Ŝ + tr(S⁻¹Ŝ) − p], S = prediction + noise + floor.
double log_likelihood(const Trial& trial, const Predictions& predictions, const LikelihoodContext& context);

/// A trial's own, whatever powers `context` has.
BinPowers bin_powers(const Trial& trial, const Predictions& predictions, const LikelihoodContext& context);

/// The same with its slope. The sums are made in a fixed order, whatever the number of threads.
LikelihoodSlope likelihood_slope(const Trial& trial, const std::vector<Unknown>& unknowns,
                                 const Predictions& predictions, const std::vector<PredictionDerivative>& derivatives,
                                 const LikelihoodContext& context);

/// What neighbouring bins of one observation add to the gradient of the log-likelihood; at its top they sum up to
/// nothing (or the beliefs' pull).
struct GradientBlock {
    std::size_t observation = 0;
    double frequency_hz = 0.0;  ///< the first bin's
    Eigen::VectorXd gradient;   ///< one element per unknown
};

/// The gradient in blocks of a few hertz, observation by observation, upwards. Time series only.
std::vector<GradientBlock> gradient_blocks(const Trial& trial, const std::vector<Unknown>& unknowns,
                                           const Predictions& predictions,
                                           const std::vector<PredictionDerivative>& derivatives,
                                           const LikelihoodContext& context);

/// Noise of every channel at a bin of an observation.
Eigen::VectorXd noise_powers(const Trial& trial, const Observation& observation, std::size_t index, std::size_t bin);

/// Prediction with noise and floor at a bin of an observation.
Eigen::MatrixXcd complete_prediction(const Trial& trial, const Observation& observation, std::size_t index,
                                     const ExpectedSpectra& prediction, std::size_t bin, double least_floor = 0.0);

}  // namespace railpem::diagnosis
