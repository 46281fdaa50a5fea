#include "diagnosis/fit.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "parameters/parameter_error.hpp"

namespace railpem::diagnosis {

namespace {

constexpr double kFirstDamping = 1e-3;
constexpr double kMostDamping = 1e6;
constexpr double kLongestStep = 3.0;  ///< in deviations of the belief

struct State {
    Trial trial;
    std::vector<double> values;
    Predictions predictions;
    double log_likelihood = 0.0;
    double log_posterior = -std::numeric_limits<double>::infinity();
};

double log_belief(const std::vector<Unknown>& unknowns, const std::vector<double>& values) {
    double sum = 0.0;
    for (std::size_t i = 0; i < unknowns.size(); ++i) {
        const double distance = (values[i] - unknowns[i].mean) / unknowns[i].deviation;
        sum -= 0.5 * distance * distance;
    }
    return sum;
}

/// The state at `values`; a value that physics forbids has no probability.
State state_at(const Trial& base, const std::vector<Unknown>& unknowns, std::vector<double> values, const LikelihoodContext& context) {
    State state{.trial = base, .values = std::move(values)};
    try {
        set_values(state.trial, unknowns, state.values);
        state.predictions = predict(state.trial, context);
    } catch (const parameters::ParameterError&) {
        return state;
    }
    state.log_likelihood = log_likelihood(state.trial, state.predictions, context);
    state.log_posterior = state.log_likelihood + log_belief(unknowns, state.values);
    return state;
}

struct Normal {
    Eigen::VectorXd gradient;  ///< of the log-posterior
    Eigen::MatrixXd curvature; ///< F + D⁻²
    Eigen::MatrixXd information;
};

Normal normal_equations(const State& state, const std::vector<Unknown>& unknowns, const LikelihoodContext& context) {
    const std::vector<PredictionDerivative> derivatives = differentiate(state.trial, unknowns, state.values, state.predictions, context);
    const LikelihoodSlope slope = likelihood_slope(state.trial, unknowns, state.predictions, derivatives, context);
    Normal normal{.gradient = slope.gradient, .curvature = slope.information, .information = slope.information};
    for (std::size_t i = 0; i < unknowns.size(); ++i) {
        const double weight = 1.0 / (unknowns[i].deviation * unknowns[i].deviation);
        normal.gradient(static_cast<long>(i)) -= weight * (state.values[i] - unknowns[i].mean);
        normal.curvature(static_cast<long>(i), static_cast<long>(i)) += weight;
    }
    return normal;
}

/// The damped step; unknowns that a bound holds are left where they are.
Eigen::VectorXd damped_step(const Normal& normal, const State& state, const std::vector<Unknown>& unknowns, double damping) {
    Eigen::MatrixXd matrix = normal.curvature;
    Eigen::VectorXd gradient = normal.gradient;
    matrix.diagonal() *= 1.0 + damping;
    for (std::size_t i = 0; i < unknowns.size(); ++i) {
        const long at = static_cast<long>(i);
        const bool held = (state.values[i] >= unknowns[i].high && gradient(at) > 0.0) || (state.values[i] <= unknowns[i].low && gradient(at) < 0.0);
        if (!held) continue;
        matrix.row(at).setZero();
        matrix.col(at).setZero();
        matrix(at, at) = 1.0;
        gradient(at) = 0.0;
    }
    return matrix.ldlt().solve(gradient);
}

std::vector<double> moved(const State& state, const std::vector<Unknown>& unknowns, const Eigen::VectorXd& step) {
    std::vector<double> values = state.values;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double longest = kLongestStep * unknowns[i].deviation;
        values[i] += std::clamp(step(static_cast<long>(i)), -longest, longest);
        values[i] = std::clamp(values[i], unknowns[i].low, unknowns[i].high);
    }
    return values;
}

/// Climbs at one floor. Returns true when a further step promises too little.
bool climb(const Trial& base, const std::vector<Unknown>& unknowns, const LikelihoodContext& context, const FitOptions& options,
           int most, double& damping, State& state, int& iterations, Normal* last = nullptr) {
    for (int i = 0; i < most; ++i) {
        if (options.between) options.between();
        const Normal normal = normal_equations(state, unknowns, context);
        ++iterations;
        bool better = false;
        while (damping < kMostDamping) {
            const Eigen::VectorXd step = damped_step(normal, state, unknowns, damping);
            if (0.5 * step.dot(normal.gradient) < options.least_gain) {
                if (last) *last = normal;
                return true;
            }
            State next = state_at(base, unknowns, moved(state, unknowns, step), context);
            better = next.log_posterior > state.log_posterior;
            if (better) {
                state = std::move(next);
                damping = std::max(damping / 10.0, 1e-9);
                break;
            }
            damping *= 10.0;
        }
        if (!better) {
            damping = kFirstDamping;
            return false;
        }
    }
    return false;
}

}  // namespace

double Fit::deviation(std::size_t unknown) const { return std::sqrt(covariance(static_cast<long>(unknown), static_cast<long>(unknown))); }

const Unknown* Fit::find(const std::string& name, std::size_t* index) const {
    for (std::size_t i = 0; i < unknowns.size(); ++i)
        if (unknowns[i].name == name) {
            if (index) *index = i;
            return &unknowns[i];
        }
    return nullptr;
}

std::vector<double> means(const std::vector<Unknown>& unknowns) {
    std::vector<double> values;
    for (const Unknown& unknown : unknowns) values.push_back(unknown.mean);
    return values;
}

Fit fit(const Trial& base, std::vector<Unknown> unknowns, std::vector<double> start, const LikelihoodContext& context,
        const FitOptions& options) {
    Fit result;
    LikelihoodContext stage = context;
    double damping = kFirstDamping;
    std::vector<double> values = std::move(start);
    if (options.from_far)  // blunted by 10 % there is one broad maximum; each stage brings the next within reach
        for (const double floor : options.stages) {
            stage.least_floor = floor;
            State state = state_at(base, unknowns, std::move(values), stage);
            climb(base, unknowns, stage, options, options.stage_iterations, damping, state, result.iterations);
            values = std::move(state.values);
        }
    State state = state_at(base, unknowns, std::move(values), context);
    Normal normal;
    result.converged = climb(base, unknowns, context, options, options.iterations, damping, state, result.iterations, &normal);
    if (!result.converged) normal = normal_equations(state, unknowns, context);
    const long size = static_cast<long>(unknowns.size());
    Eigen::VectorXd deviations(size);
    for (long i = 0; i < size; ++i) deviations(i) = unknowns[static_cast<std::size_t>(i)].deviation;
    const Eigen::MatrixXd scaled = deviations.asDiagonal() * normal.curvature * deviations.asDiagonal();
    const Eigen::LLT<Eigen::MatrixXd> factor(scaled);
    double log_determinant = 0.0;
    for (long i = 0; i < size; ++i) log_determinant += 2.0 * std::log(factor.matrixLLT()(i, i));
    result.covariance = deviations.asDiagonal() * factor.solve(Eigen::MatrixXd::Identity(size, size)) * deviations.asDiagonal();
    result.log_likelihood = state.log_likelihood;
    result.log_posterior = state.log_posterior;
    result.log_evidence = state.log_posterior - 0.5 * log_determinant;
    result.information = normal.information;
    result.gradient = normal.gradient;
    result.trial = std::move(state.trial);
    result.values = std::move(state.values);
    result.predictions = std::move(state.predictions);
    result.unknowns = std::move(unknowns);
    return result;
}

}  // namespace railpem::diagnosis
