#pragma once
// Which hypotheses point where the retuned case cannot follow: cheap, before any refit.

#include <vector>

#include "diagnosis/fit/fit.hpp"
#include "diagnosis/hypotheses/candidates.hpp"

namespace railpem::diagnosis {

/// What a hypothesis promises to first order.
struct Promise {
    std::size_t candidate = 0;
    double gain = 0.0;      ///< nats of log-posterior, nuisances free: ½ g⊥²/F⊥
    double strength = 0.0;  ///< step along the direction, in units of the candidate's probe
    Eigen::VectorXd move;   ///< of the fit's unknowns that goes with a unit of strength
};

/// Score of every candidate at a fit, all its unknowns projected out; sorted, most promising first. A one-sided
/// candidate that would have to be negative promises nothing.
std::vector<Promise> screen(const Fit& fit, const std::vector<Candidate>& candidates, const LikelihoodContext& context);

/// What unknowns that are not in the fit would bring to first order when all of them are free within their beliefs:
/// log-evidence ½ gᵀ(F⊥ + D⁻²)⁻¹g − ½ log det(1 + D F⊥ D), and their most probable values with covariance.
struct FreedomPromise {
    double nats = 0.0;
    Eigen::VectorXd values;
    Eigen::MatrixXd covariance;
    Eigen::VectorXd move;  ///< of the fit's unknowns that goes with them
};
/// Derivatives of the predictions with the unknowns of a freedom, by its place among the freedoms;
/// PredictionDerivative::unknown counts its own unknowns.
using FreedomDerivatives = std::function<std::vector<PredictionDerivative>(std::size_t)>;

/// One promise for each of the freedoms; without `derivatives` they are differences.
std::vector<FreedomPromise> promises_of(const Fit& fit, const std::vector<std::vector<Unknown>>& freedoms,
                                        const LikelihoodContext& context, const FreedomDerivatives& derivatives = {});

/// Gain of releasing one number of the fit from its tolerance (deviation → `wide`), to first order.
double release_gain(const Fit& fit, std::size_t unknown, double wide);

}  // namespace railpem::diagnosis
