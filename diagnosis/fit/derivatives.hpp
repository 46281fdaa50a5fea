#pragma once
// Derivatives of predictions, kept for suppositions near the one at which they were taken.

#include <string>
#include <vector>

#include "diagnosis/likelihood/likelihood.hpp"

namespace railpem::diagnosis {

/// Derivatives of the predictions with every unknown that moves them (not noise and floor), by differences.
std::vector<PredictionDerivative> differentiate(const Trial& trial, const std::vector<Unknown>& unknowns,
                                                const std::vector<double>& values, const Predictions& predictions,
                                                const LikelihoodContext& context);

/// Derivatives of the predictions of one trial, and what they belong to.
struct Derivatives {
    std::vector<std::string> names;  ///< of the unknowns that PredictionDerivative::unknown counts
    std::vector<PredictionDerivative> values;
    std::vector<ExpectedSpectra> at;  ///< the predictions there
};

/// Derivatives at one prediction in the place of those at another: each in proportion to the amplitudes of its two
/// channels. Exact where all that has changed is the power of channels (the irregularity's level), near where little
/// has. Values of scalar recordings stay.
void carry(std::vector<PredictionDerivative>& derivatives, const std::vector<ExpectedSpectra>& from,
           const std::vector<ExpectedSpectra>& to, const LikelihoodContext& context);

/// Derivatives for a trial near that of `known`: carried for the unknowns of retuning that it knows, anew for the
/// others (effects and free corrections always: two members may share a name). `known.at` and `predictions` are of the
/// same observations.
std::vector<PredictionDerivative> derivatives_near(const Derivatives& known, const Trial& trial,
                                                   const std::vector<Unknown>& unknowns,
                                                   const std::vector<double>& values, const Predictions& predictions,
                                                   const LikelihoodContext& context);

}  // namespace railpem::diagnosis
