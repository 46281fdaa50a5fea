#pragma once
// The way to the most probable values: Fisher scoring with Levenberg damping.

#include <Eigen/Core>
#include <functional>
#include <limits>
#include <vector>

#include "diagnosis/fit/derivatives.hpp"
#include "diagnosis/fit/fit_settings.hpp"
#include "diagnosis/likelihood/likelihood.hpp"

namespace railpem::diagnosis {

/// A point of a climb.
struct State {
    Trial trial;
    std::vector<double> values;
    Predictions predictions;  ///< empty where physics forbids the values
    double log_likelihood = 0.0;
    double log_posterior = -std::numeric_limits<double>::infinity();
    bool possible() const { return !predictions.spectra.empty(); }
};

/// −½Σ((x − mean)/deviation)².
double log_belief(const std::vector<Unknown>& unknowns, const std::vector<double>& values);

/// The state at `values`; a value that physics forbids has no probability.
State state_at(const Trial& base, const std::vector<Unknown>& unknowns, std::vector<double> values,
               const LikelihoodContext& context);

/// How probable a state is by another likelihood, or with other beliefs: its predictions stay.
void weigh(const std::vector<Unknown>& unknowns, const LikelihoodContext& context, State& state);

/// Noise and floor alone: the predictions stay, so that a step costs next to nothing. As the numbers come nearer, what
/// was taken for floor shrinks, and the next step of the numbers sees sharper.
void settle(const std::vector<Unknown>& unknowns, const LikelihoodContext& context, State& state,
            const FitSettings& settings = kFitSettings);

/// Second-order picture of the log-posterior.
struct Normal {
    double log_likelihood = 0.0;
    Eigen::VectorXd gradient;
    Eigen::MatrixXd curvature;    ///< F + D⁻²
    Eigen::MatrixXd information;  ///< F
};

Normal normal_equations(const State& state, const std::vector<Unknown>& unknowns,
                        const std::vector<PredictionDerivative>& derivatives, const LikelihoodContext& context);

/// Derivatives that a climb goes by. Taken anew they cost thirty predictions and more; carried from step to step
/// (carry()) none.
struct Slopes {
    std::vector<PredictionDerivative> values;
    int carried = 0;       ///< steps since they were taken
    bool trusted = false;  ///< whether the next step may go by them
};

/// How a climb ended.
enum class End { top, tired, hopeless };

inline constexpr double kNoRival = -1e300;  ///< a log-posterior that nothing lies below

struct ClimbOptions {
    FitSettings settings = kFitSettings;
    double least_gain = settings.least_gain;  ///< nats: it ends when a step promises less
    int most = settings.iterations;           ///< times that derivatives are taken
    double rival = kNoRival;                  ///< log-posterior of the best rival
    /// the top counts: it is seen with derivatives of its own, and what is left behind a rival is less
    bool sharp = true;
    std::function<void()> between;  ///< called between steps; may throw to stop
};

/// Climbs from `state`. Steps go by carried derivatives as long as they bring what they promise; a sharp top is reached
/// with `slopes` taken there, and `last` is the picture at the end where the climb came to a top.
End climb(const Trial& base, const std::vector<Unknown>& unknowns, const LikelihoodContext& context,
          const ClimbOptions& options, double& damping, State& state, Slopes& slopes, int& iterations, Normal& last);

}  // namespace railpem::diagnosis
