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
constexpr double kLongestStep = 3.0;      ///< in deviations of the belief
constexpr double kLongestLogStep = 1.0;   ///< of noise and floor: far below what shows, their slope promises anything
constexpr int kSettleIterations = 3;      ///< of noise and floor alone, after every step
constexpr double kWorthSettling = 2.0;    ///< nats promised by a step, after which noise and floor are settled
constexpr double kWorthFinishing = 0.1;  ///< of the gain at which a climb ends: what an undamped step has to promise to be made
constexpr double kHope = 3.0;             ///< times its promise, a fit may still climb
constexpr double kPace = 12.0;            ///< or times what its last step brought: a ridge is climbed in many equal steps
constexpr int kHeldIterations = 8;        ///< with the lines held: what a climb from afar gains by holding them longer is lost when it lets them go
constexpr double kSurprise = 1.5;         ///< times what a step promised
constexpr double kStageGain = 3.0;        ///< nats that a step of a blunt stage has to promise: its top is not the one that counts
constexpr double kHopeless = 30.0;        ///< nats that a fit must stay behind, hope included, to be given up
constexpr double kHopelessBlunt = 300.0;  ///< the same where the likelihood is blunt, lines are held and a rival's are not: a rail that shears stayed 54 behind a damper there, and came out 1100 ahead

struct State {
    Trial trial;
    std::vector<double> values;
    Predictions predictions;
    double log_likelihood = 0.0;
    double log_posterior = -std::numeric_limits<double>::infinity();
    bool possible() const { return !predictions.spectra.empty(); }
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

Normal normal_equations(const State& state, const std::vector<Unknown>& unknowns, const std::vector<PredictionDerivative>& derivatives,
                        const LikelihoodContext& context) {
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

bool is_diagonal(const Unknown& unknown) { return unknown.kind == UnknownKind::noise || unknown.kind == UnknownKind::floor; }

std::vector<double> moved(const State& state, const std::vector<Unknown>& unknowns, const Eigen::VectorXd& step) {
    std::vector<double> values = state.values;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double longest = is_diagonal(unknowns[i]) ? kLongestLogStep : kLongestStep * unknowns[i].deviation;
        values[i] += std::clamp(step(static_cast<long>(i)), -longest, longest);
        values[i] = std::clamp(values[i], unknowns[i].low, unknowns[i].high);
    }
    return values;
}

/// Noise and floor alone: the predictions stay, so that a step costs next to nothing. As the numbers come nearer, what was taken for
/// floor shrinks, and the next step of the numbers sees sharper.
void settle(const std::vector<Unknown>& unknowns, const LikelihoodContext& context, State& state) {
    for (int i = 0; i < kSettleIterations; ++i) {
        Normal normal = normal_equations(state, unknowns, {}, context);
        for (std::size_t u = 0; u < unknowns.size(); ++u)
            if (!is_diagonal(unknowns[u])) normal.gradient(static_cast<long>(u)) = 0.0;
        const Eigen::VectorXd step = damped_step(normal, state, unknowns, 0.0);
        if (0.5 * step.dot(normal.gradient) < kWorthSettling) return;
        std::vector<double> values = moved(state, unknowns, step);
        Trial trial = state.trial;
        set_values(trial, unknowns, values);
        const double own = log_likelihood(trial, state.predictions, context), posterior = own + log_belief(unknowns, values);
        if (!(posterior > state.log_posterior)) return;
        state.trial = std::move(trial);
        state.values = std::move(values);
        state.log_likelihood = own;
        state.log_posterior = posterior;
    }
}

/// The last step, undamped. Damping, in proportion to what the data say of each number alone, keeps a climb from moving all of them together: the common scale of vehicle
/// and track, which only beliefs know, stayed where the climb had begun, a deviation off.
void finish(const Trial& base, const std::vector<Unknown>& unknowns, const LikelihoodContext& context, double least_gain, Normal& normal, State& state) {
    const Eigen::VectorXd step = damped_step(normal, state, unknowns, 0.0);
    if (0.5 * step.dot(normal.gradient) < kWorthFinishing * least_gain) return;
    State next = state_at(base, unknowns, moved(state, unknowns, step), context);
    if (!(next.log_posterior > state.log_posterior)) return;
    state = std::move(next);
    // Anew, not by the curvature: what is projected on it later has the same errors of differences, and they cancel.
    normal = normal_equations(state, unknowns, differentiate(state.trial, unknowns, state.values, state.predictions, context), context);
}

/// How a climb ended.
enum class End { top, tired, hopeless };

/// Climbs at one floor.
End climb(const Trial& base, const std::vector<Unknown>& unknowns, const LikelihoodContext& context, const FitOptions& options,
          double rival, int most, double& damping, State& state, int& iterations, Normal* last = nullptr) {
    double gained = std::numeric_limits<double>::infinity(), promised = 0.0;  // by the last step
    const double room = last ? kHopeless : kHopelessBlunt;
    for (int i = 0; i < most; ++i) {
        if (options.between) options.between();
        Normal normal = normal_equations(state, unknowns, differentiate(state.trial, unknowns, state.values, state.predictions, context), context);
        ++iterations;
        bool better = false;
        while (damping < kMostDamping && !better) {
            const Eigen::VectorXd step = damped_step(normal, state, unknowns, damping);
            const double promise = 0.5 * step.dot(normal.gradient);
            // Little is promised, and the last step brought next to nothing of what it had promised.
            const bool flat = promise < kWorthSettling && gained < options.least_gain;
            // Only where the last step brought no more than it promised: a climb that surprises has not said yet how high it goes.
            const bool hopeless = gained < kSurprise * promised && state.log_posterior + std::max(kHope * promise, kPace * gained) + room < rival;
            if (promise < options.least_gain || flat || hopeless) {
                if (last && !hopeless) finish(base, unknowns, context, options.least_gain, normal, state);
                if (last) *last = normal;
                return hopeless ? End::hopeless : End::top;
            }
            State next = state_at(base, unknowns, moved(state, unknowns, step), context);
            better = next.log_posterior > state.log_posterior;
            if (!better && promise < kWorthSettling && next.log_posterior > state.log_posterior - options.least_gain) gained = 0.0;
            damping = better ? std::max(damping / 10.0, 1e-9) : damping * 10.0;
            if (!better) continue;
            gained = next.log_posterior - state.log_posterior;
            promised = promise;
            state = std::move(next);
            if (promise > kWorthSettling) settle(unknowns, context, state);
        }
        if (!better) {
            damping = kFirstDamping;
            return End::tired;
        }
    }
    return End::tired;
}

/// The unknowns of a blunt stage. Lines at which sleepers pass stay as they are: as long as a speed is off by the width of one, the nearest top has
/// them drowned or smeared over the band, and no later step finds them again.
std::vector<Unknown> with_lines_held(std::vector<Unknown> unknowns, const std::vector<double>& values) {
    for (std::size_t i = 0; i < unknowns.size(); ++i)
        if (unknowns[i].kind == UnknownKind::passing || unknowns[i].kind == UnknownKind::width) unknowns[i].low = unknowns[i].high = values[i];
    return unknowns;
}

/// The most probable of all widths of lines, tried a factor e apart and then in halved steps about the best: the derivative at lines narrower than a bin
/// says nothing of wide ones, and the other way round.
void choose_width(const Trial& base, const std::vector<Unknown>& unknowns, const LikelihoodContext& context, State& state) {
    for (std::size_t u = 0; u < unknowns.size(); ++u) {
        if (unknowns[u].kind != UnknownKind::width) continue;
        const auto try_width = [&](double width) {
            std::vector<double> values = state.values;
            values[u] = std::clamp(width, unknowns[u].low, unknowns[u].high);
            State next = state_at(base, unknowns, std::move(values), context);
            if (next.log_posterior > state.log_posterior) state = std::move(next);
        };
        for (double width = unknowns[u].low; width < unknowns[u].high; width += 1.0) try_width(width);
        try_width(unknowns[u].high);
        for (const double step : {0.5, 0.25}) {
            const double best = state.values[u];
            try_width(best - step);
            try_width(best + step);
        }
    }
}

/// What the rival reaches where the likelihood is blunt. Its noise and floor are those of the sharp likelihood: seen too low rather than too high.
double blunt_posterior(const Fit& rival, const LikelihoodContext& stage) {
    return log_likelihood(rival.trial, rival.predictions, stage) + log_belief(rival.unknowns, rival.values);
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

double log_posterior_at(const Trial& base, const std::vector<Unknown>& unknowns, std::vector<double> values, const LikelihoodContext& context) {
    return state_at(base, unknowns, std::move(values), context).log_posterior;
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
    FitOptions blunt = options;
    blunt.least_gain = std::max(options.least_gain, kStageGain);
    double damping = kFirstDamping;
    std::vector<double> values = std::move(start);
    const auto impossible = [&](State& state) {
        constexpr double kNever = -std::numeric_limits<double>::infinity();
        return Fit{.trial = std::move(state.trial), .unknowns = unknowns, .values = std::move(state.values), .log_likelihood = kNever, .log_posterior = kNever, .log_evidence = kNever};
    };
    constexpr double kNobody = -1e300;
    End end = End::top;
    if (options.from_far) {  // blunted by 10 % there is one broad maximum; each stage brings the next within reach
        const std::vector<Unknown> held = with_lines_held(unknowns, values);
        std::vector<double> floors = options.stages;
        floors.push_back(context.least_floor);
        for (const double floor : floors) {
            stage.least_floor = floor;
            State state = state_at(base, held, std::move(values), stage);
            if (!state.possible()) return impossible(state);
            settle(held, stage, state);
            const double rival = options.rival ? blunt_posterior(*options.rival, stage) - options.room : kNobody;
            const int most = floor > context.least_floor ? options.stage_iterations : std::min(options.iterations, kHeldIterations);
            end = climb(base, held, stage, blunt, rival, most, damping, state, result.iterations);
            values = std::move(state.values);
            if (end == End::top && state.log_posterior + kHopelessBlunt < rival) end = End::hopeless;
            if (end == End::hopeless) break;
        }
    }
    State state = state_at(base, unknowns, std::move(values), context);
    if (!state.possible()) return impossible(state);
    settle(unknowns, context, state);
    if (options.from_far && end != End::hopeless) choose_width(base, unknowns, context, state);
    Normal normal;
    const double rival = options.rival ? options.rival->log_posterior - options.room : kNobody;
    if (end != End::hopeless) end = climb(base, unknowns, context, options, rival, options.iterations, damping, state, result.iterations, &normal);
    result.converged = end == End::top;
    if (normal.gradient.size() == 0) normal = normal_equations(state, unknowns, differentiate(state.trial, unknowns, state.values, state.predictions, context), context);
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
