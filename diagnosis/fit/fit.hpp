#pragma once
// The most probable trial: retuning, and refitting with an effect added.

#include <Eigen/Core>
#include <functional>
#include <limits>
#include <memory>
#include <vector>

#include "diagnosis/fit/derivatives.hpp"
#include "diagnosis/fit/fit_settings.hpp"
#include "diagnosis/likelihood/likelihood.hpp"

namespace railpem::diagnosis {

/// A fit's way and end.
struct FitOptions {
    FitSettings settings = kFitSettings;
    int iterations = settings.iterations;     ///< FitSettings::iterations
    double least_gain = settings.least_gain;  ///< FitSettings::least_gain
    double patience = settings.patience;      ///< FitSettings::patience
    bool from_far = true;  ///< begin with a blunt likelihood (large floor) that is sharpened in stages
    /// floors of the blunt likelihoods, when it begins with them
    std::vector<double> stages = {settings.ladder.begin(), settings.ladder.end()};
    int stage_iterations = settings.rung_iterations;
    /// the best rival: a fit that cannot come near is given up, also where the likelihood is still blunt
    const struct Fit* rival = nullptr;
    double room = 0.0;                        ///< nats that the fit may stay behind the rival
    std::shared_ptr<const Derivatives> near;  ///< taken near the start, when there are any: the first steps go by them
    std::function<void()> between;            ///< called between steps; may throw to stop
};

struct Fit {
    Trial trial;
    std::vector<Unknown> unknowns;
    std::vector<double> values;
    double log_likelihood = 0.0;  ///< of the fitted part, relative to the saturated model
    double log_posterior = 0.0;   ///< with the beliefs: −½Σ((x − mean)/deviation)²
    double log_evidence = 0.0;    ///< Laplace: log_posterior − ½ log det(1 + D·F·D), D the deviations
    Eigen::MatrixXd information;  ///< of the data, Fisher
    Eigen::VectorXd gradient;     ///< of the log-posterior at the end
    Eigen::MatrixXd covariance;   ///< of the unknowns: (F + D⁻²)⁻¹
    Predictions predictions;
    int iterations = 0;  ///< times that derivatives were taken
    bool converged = false;
    /// at `values`; none where the fit was given up, or where they were let go (a megabyte for every unknown and
    /// recording)
    std::shared_ptr<const Derivatives> derivatives;

    double deviation(std::size_t unknown) const;  ///< standard deviation of an unknown
    const Unknown* find(const std::string& name, std::size_t* index = nullptr) const;
};

/// Log-posterior at given values, without climbing; −∞ where physics forbids them.
double log_posterior_at(const Trial& base, const std::vector<Unknown>& unknowns, std::vector<double> values,
                        const LikelihoodContext& context);

/// Where a climb ends that goes by derivatives taken `near` the start (of retuning; those of an effect are taken anew),
/// as long as its steps bring what they promise; −∞ where physics forbids the start. It is given up where it cannot
/// come near the log-posterior of a `rival`, and stands lower then.
struct Approach {
    double log_posterior = 0.0;
    std::vector<double> values;
};
Approach approach(const Trial& base, const std::vector<Unknown>& unknowns, std::vector<double> start,
                  const Derivatives& near, const LikelihoodContext& context,
                  double rival = -std::numeric_limits<double>::infinity());

/// Fits `unknowns` from `start` by Fisher scoring with Levenberg damping within the bounds. From a start that physics
/// forbids there is no fit: its logarithms are −∞, predictions and covariance empty.
Fit fit(const Trial& base, std::vector<Unknown> unknowns, std::vector<double> start, const LikelihoodContext& context,
        const FitOptions& options = {});

/// Derivatives at a fit's values: its own, or taken anew where it has none.
std::vector<PredictionDerivative> derivatives_of(const Fit& fit, const LikelihoodContext& context);

/// Fills the caches of a fit's predictions again where they were let go: combs are sought in its transfers, and many
/// derivatives there would each solve the rail.
void restore_caches(Fit& fit, const LikelihoodContext& context);

/// Takes the derivatives of a fit again where they were let go, for who asks for them more than once.
void restore_derivatives(Fit& fit, const LikelihoodContext& context);

/// Means of the unknowns' beliefs.
std::vector<double> means(const std::vector<Unknown>& unknowns);

}  // namespace railpem::diagnosis
