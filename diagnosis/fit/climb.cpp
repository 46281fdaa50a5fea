#include "diagnosis/fit/climb.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

#include "diagnosis/fit/bounded_step.hpp"
#include "diagnosis/likelihood/scalar_likelihood.hpp"
#include "parameters/parameter_error.hpp"

namespace railpem::diagnosis {

namespace {

bool is_diagonal(const Unknown& unknown) {
    return unknown.kind == UnknownKind::noise || unknown.kind == UnknownKind::flicker ||
           unknown.kind == UnknownKind::floor;
}

/// The logarithm of a power that may be far below what shows: there its slope promises anything.
bool is_log_power(const Unknown& unknown) {
    return is_diagonal(unknown) || unknown.kind == UnknownKind::met_alone;
}

/// How far an unknown may move: to its bounds, and no further than its slope can be believed.
std::pair<double, double> reach(const Unknown& unknown, double value, const FitSettings& settings) {
    double longest = is_log_power(unknown) ? settings.longest_log_step : settings.longest_step * unknown.deviation;
    if (unknown.kind == UnknownKind::number) longest = std::min(longest, settings.longest_number_step);
    return {std::max(unknown.low - value, -longest), std::min(unknown.high - value, longest)};
}

/// The damped step within the reach of every unknown. Cut off each by itself, unknowns that a step moves against each
/// other would not belong together any more.
Eigen::VectorXd damped_step(const Normal& normal, const State& state, const std::vector<Unknown>& unknowns,
                            double damping, const FitSettings& settings) {
    Eigen::MatrixXd matrix = normal.curvature;
    matrix.diagonal() *= 1.0 + damping;
    Eigen::VectorXd low(normal.gradient.size()), high(normal.gradient.size());
    for (std::size_t i = 0; i < unknowns.size(); ++i)
        std::tie(low(static_cast<long>(i)), high(static_cast<long>(i))) = reach(unknowns[i], state.values[i], settings);
    return bounded_step(matrix, normal.gradient, low, high, settings);
}

std::vector<double> moved(const State& state, const Eigen::VectorXd& step) {
    std::vector<double> values = state.values;
    for (std::size_t i = 0; i < values.size(); ++i) values[i] += step(static_cast<long>(i));
    return values;
}

/// What the second-order picture expects of a step.
double promise_of(const Normal& normal, const Eigen::VectorXd& step) {
    return step.dot(normal.gradient) - 0.5 * step.dot(normal.curvature * step);
}

void take(const std::vector<Unknown>& unknowns, const LikelihoodContext& context, const State& state, Slopes& slopes) {
    slopes = {differentiate(state.trial, unknowns, state.values, state.predictions, context), 0, true};
}

/// The last step, undamped. Damping, in proportion to what the data say of each number alone, keeps a climb from moving
/// all of them together: the common scale of vehicle and track, which only beliefs know, stayed where the climb had
/// begun, a deviation off.
void finish(const Trial& base, const std::vector<Unknown>& unknowns, const LikelihoodContext& context,
            const ClimbOptions& options, Normal& normal, State& state, Slopes& slopes) {
    const Eigen::VectorXd step = damped_step(normal, state, unknowns, 0.0, options.settings);
    if (promise_of(normal, step) < options.settings.worth_finishing * options.least_gain) return;
    State next = state_at(base, unknowns, moved(state, step), context);
    if (!(next.log_posterior > state.log_posterior)) return;
    state = std::move(next);
    // Anew, not by the curvature: what is projected on it later has the same errors of differences, and they cancel.
    take(unknowns, context, state, slopes);
    normal = normal_equations(state, unknowns, slopes.values, context);
}

}  // namespace

double log_belief(const std::vector<Unknown>& unknowns, const std::vector<double>& values) {
    double sum = 0.0;
    for (std::size_t i = 0; i < unknowns.size(); ++i) {
        const double distance = (values[i] - unknowns[i].mean) / unknowns[i].deviation;
        sum -= 0.5 * distance * distance;
    }
    return sum;
}

void weigh(const std::vector<Unknown>& unknowns, const LikelihoodContext& context, State& state) {
    state.log_likelihood = log_likelihood(state.trial, state.predictions, context);
    state.log_posterior = state.log_likelihood + log_belief(unknowns, state.values);
}

State state_at(const Trial& base, const std::vector<Unknown>& unknowns, std::vector<double> values,
               const LikelihoodContext& context) {
    State state{.trial = base, .values = std::move(values), .predictions = {}};
    try {
        set_values(state.trial, unknowns, state.values);
        state.predictions = predict(state.trial, context);
    } catch (const parameters::ParameterError&) {
        return state;
    }
    weigh(unknowns, context, state);
    return state;
}

Normal normal_equations(const State& state, const std::vector<Unknown>& unknowns,
                        const std::vector<PredictionDerivative>& derivatives, const LikelihoodContext& context) {
    const LikelihoodSlope slope = likelihood_slope(state.trial, unknowns, state.predictions, derivatives, context);
    Normal normal{.log_likelihood = slope.log_likelihood,
                  .gradient = slope.gradient,
                  .curvature = slope.information,
                  .information = slope.information};
    for (std::size_t i = 0; i < unknowns.size(); ++i) {
        const double weight = 1.0 / (unknowns[i].deviation * unknowns[i].deviation);
        normal.gradient(static_cast<long>(i)) -= weight * (state.values[i] - unknowns[i].mean);
        normal.curvature(static_cast<long>(i), static_cast<long>(i)) += weight;
    }
    return normal;
}

void settle(const std::vector<Unknown>& unknowns, const LikelihoodContext& context, State& state,
            const FitSettings& settings) {
    Normal normal = normal_equations(state, unknowns, {}, context);
    for (int i = 0; i < settings.settle_iterations; ++i) {
        for (std::size_t u = 0; u < unknowns.size(); ++u)
            if (!is_diagonal(unknowns[u])) normal.gradient(static_cast<long>(u)) = 0.0;
        const Eigen::VectorXd step = damped_step(normal, state, unknowns, 0.0, settings);
        if (promise_of(normal, step) < settings.worth_settling) return;
        Trial before = state.trial;
        std::vector<double> values = moved(state, step);
        std::swap(state.values, values);
        set_values(state.trial, unknowns, state.values);
        // The slope says how probable it is along with the next step, which all but the last have.
        const bool last = i + 1 == settings.settle_iterations;
        if (!last) normal = normal_equations(state, unknowns, {}, context);
        const double own = last ? log_likelihood(state.trial, state.predictions, context) : normal.log_likelihood,
                     posterior = own + log_belief(unknowns, state.values);
        if (!(posterior > state.log_posterior)) {
            state.trial = std::move(before);
            state.values = std::move(values);
            return;
        }
        state.log_likelihood = own;
        state.log_posterior = posterior;
    }
}

namespace {

class Climb {
  public:
    Climb(const Trial& base, const std::vector<Unknown>& unknowns, const LikelihoodContext& context,
          const ClimbOptions& options, double& damping, State& state, Slopes& slopes, int& iterations)
        : base_(base),
          unknowns_(unknowns),
          context_(context),
          held_(context),
          options_(options),
          settings_(options.settings),
          damping_(damping),
          state_(state),
          slopes_(slopes),
          iterations_(iterations) {}

    End run(Normal& last) {
        const std::optional<End> end = steps(last);
        weigh(unknowns_, context_, state_);
        return end.value_or(End::tired);
    }

  private:
    /// The likelihood with the processes of every bin as the state has them: its slope takes them as given, and a
    /// likelihood in which they move has its top elsewhere. Promises of 15 nats were not kept where a law is an
    /// approximation.
    void hold() {
        powers_ = bin_powers(state_.trial, state_.predictions, held_);
        held_.powers = &powers_;
        state_.log_likelihood = powers_.log_likelihood + scalar_log_likelihood(state_.trial, state_.predictions, held_);
        state_.log_posterior = state_.log_likelihood + log_belief(unknowns_, state_.values);
    }

    std::optional<End> steps(Normal& last) {
        hold();
        for (int taken = 0; taken < options_.most || slopes_.trusted;) {
            if (options_.between) options_.between();
            if (!slopes_.trusted) {
                if (taken > 0) hold();
                take(unknowns_, held_, state_, slopes_);
                ++taken;
                ++iterations_;
            }
            Normal normal = normal_equations(state_, unknowns_, slopes_.values, held_);
            const std::optional<End> end = step(normal);
            if (end == End::top && options_.sharp) {
                finish(base_, unknowns_, held_, options_, normal, state_, slopes_);
                last = std::move(normal);
            }
            if (end) return end;
        }
        return {};
    }

    /// One step up, as short as it has to be; none: slopes that were carried here are not to be trusted. How the climb
    /// ends, if it does.
    std::optional<End> step(const Normal& normal) {
        for (; damping_ < settings_.most_damping;
             damping_ = std::max(settings_.damping_factor * damping_, settings_.first_damping)) {
            const Eigen::VectorXd move = damped_step(normal, state_, unknowns_, damping_, settings_);
            const double promise = promise_of(normal, move);
            // Only where the last step brought no more than it promised: a climb that surprises has not said yet how
            // high it goes.
            const double room = options_.sharp ? settings_.dropped_behind : settings_.dropped_behind_tempered;
            if (gained_ < settings_.surprise * promised_ &&
                state_.log_posterior + std::max(settings_.hope * promise, settings_.pace * gained_) + room <
                    options_.rival)
                return End::hopeless;
            // Little is promised, or the last step brought next to nothing of it.
            if (promise < options_.least_gain ||
                (promise < settings_.worth_settling && gained_ < options_.least_gain)) {
                if (slopes_.carried == 0 || !options_.sharp) return End::top;
                slopes_.trusted = false;  // a top is seen with slopes of its own
                return {};
            }
            State next = state_at(base_, unknowns_, moved(state_, move), held_);
            const double gain = next.log_posterior - state_.log_posterior;
            if (gain > 0.0)
                return accept(best_along(move, normal.gradient.dot(move), std::move(next)), promise, gain),
                       std::nullopt;
            if (slopes_.carried > 0) {
                slopes_.trusted = false;
                return {};
            }
            if (promise < settings_.worth_settling && gain > -options_.least_gain) gained_ = 0.0;
        }
        damping_ = settings_.first_damping;
        return End::tired;
    }

    /// The best of what a parabola through here, its slope and `next` says of the step's direction: where the model
    /// misses much, the curvature of all steps is off by as much.
    State best_along(const Eigen::VectorXd& move, double slope, State next) const {
        const double gain = next.log_posterior - state_.log_posterior, bend = 2.0 * (slope - gain);
        const double share = bend > slope / settings_.longest_share ? slope / bend : settings_.longest_share;
        const double hoped = slope * share - 0.5 * bend * share * share;
        if (hoped < gain + std::max(settings_.worth_looking * gain, options_.least_gain)) return next;
        State other = state_at(base_, unknowns_, moved(state_, stretched(move, share)), held_);
        return other.log_posterior > next.log_posterior ? std::move(other) : std::move(next);
    }

    /// A step many times as long, cut off at the bounds of every unknown.
    Eigen::VectorXd stretched(const Eigen::VectorXd& move, double share) const {
        Eigen::VectorXd step = share * move;
        for (std::size_t i = 0; i < unknowns_.size(); ++i) {
            double& own = step(static_cast<long>(i));
            own = std::clamp(own, std::min(0.0, unknowns_[i].low - state_.values[i]),
                             std::max(0.0, unknowns_[i].high - state_.values[i]));
        }
        return step;
    }

    void accept(State next, double promise, double gain) {
        gained_ = next.log_posterior - state_.log_posterior;
        promised_ = promise;
        damping_ = std::max(damping_ / settings_.damping_factor, settings_.least_damping);
        carry(slopes_.values, state_.predictions.spectra, next.predictions.spectra, context_);
        slopes_.trusted = gain > settings_.worth_carrying * promise && settings_.worth_carrying * gain < promise &&
                          ++slopes_.carried < settings_.most_carried;
        state_ = std::move(next);
        if (promise > settings_.worth_settling) settle(unknowns_, held_, state_, settings_);
    }

    const Trial& base_;
    const std::vector<Unknown>& unknowns_;
    const LikelihoodContext& context_;
    LikelihoodContext held_;
    BinPowers powers_;
    const ClimbOptions& options_;
    const FitSettings& settings_;
    double& damping_;
    State& state_;
    Slopes& slopes_;
    int& iterations_;
    double gained_ = std::numeric_limits<double>::infinity(), promised_ = 0.0;  ///< by the last step
};

}  // namespace

End climb(const Trial& base, const std::vector<Unknown>& unknowns, const LikelihoodContext& context,
          const ClimbOptions& options, double& damping, State& state, Slopes& slopes, int& iterations, Normal& last) {
    return Climb(base, unknowns, context, options, damping, state, slopes, iterations).run(last);
}

}  // namespace railpem::diagnosis
