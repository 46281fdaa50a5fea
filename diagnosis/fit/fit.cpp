#include "diagnosis/fit/fit.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "diagnosis/fit/climb.hpp"
#include "diagnosis/fit/derivatives.hpp"
#include "diagnosis/likelihood/likelihood_settings.hpp"

namespace railpem::diagnosis {

namespace {

/// The unknowns of a blunt stage. Lines at which sleepers pass stay as they are: as long as a speed is off by the width
/// of one, the nearest top has them drowned or smeared over the band, and no later step finds them again.
std::vector<Unknown> with_lines_held(std::vector<Unknown> unknowns, const std::vector<double>& values) {
    for (std::size_t i = 0; i < unknowns.size(); ++i)
        if (unknowns[i].kind == UnknownKind::passing || unknowns[i].kind == UnknownKind::width)
            unknowns[i].low = unknowns[i].high = values[i];
    return unknowns;
}

/// A state with another width of its lines; where nothing else depends on it, the transfers are those of `state`, and
/// the caches are left behind.
State with_width(const Trial& base, const std::vector<Unknown>& unknowns, const LikelihoodContext& context,
                 const State& state, std::size_t width, double value) {
    std::vector<double> values = state.values;
    values[width] = std::clamp(value, unknowns[width].low, unknowns[width].high);
    const Reuse reuse = shared_with(state.trial, unknowns[width]);
    if (reuse < Reuse::transfers) return state_at(base, unknowns, std::move(values), context);
    State next{.trial = state.trial, .values = std::move(values), .predictions = {}};
    unknowns[width].set(next.trial, next.values[width]);
    next.predictions.spectra = state.predictions.spectra;
    for (std::size_t o = 0; o < next.predictions.spectra.size(); ++o)
        if (moves(unknowns[width], next.trial, (*context.observations)[o], o))
            next.predictions.spectra[o] = predict_like(state.predictions, next.trial, context, o, reuse);
    weigh(unknowns, context, next);
    return next;
}

/// The most probable of all widths of lines, tried a factor e apart and then in halved steps about the best: the
/// derivative at lines narrower than a bin says nothing of wide ones, and the other way round.
void choose_width(const Trial& base, const std::vector<Unknown>& unknowns, const LikelihoodContext& context,
                  const FitSettings& settings, State& state) {
    for (std::size_t u = 0; u < unknowns.size(); ++u) {
        if (unknowns[u].kind != UnknownKind::width) continue;
        const auto try_width = [&](double width) {
            State next = with_width(base, unknowns, context, state, u, width);
            if (!(next.log_posterior > state.log_posterior)) return;
            if (next.predictions.caches.empty()) next.predictions.caches = std::move(state.predictions.caches);
            state = std::move(next);
        };
        for (double width = unknowns[u].low; width < unknowns[u].high; width += settings.width_step) try_width(width);
        try_width(unknowns[u].high);
        for (const double step : settings.finer_width_steps) {
            const double best = state.values[u];
            try_width(best - step);
            try_width(best + step);
        }
    }
}

std::shared_ptr<const Derivatives> kept(const std::vector<Unknown>& unknowns, std::vector<PredictionDerivative> values,
                                        const std::vector<ExpectedSpectra>& at) {
    auto own = std::make_shared<Derivatives>();
    for (const Unknown& unknown : unknowns) own->names.push_back(unknown.name);
    own->values = std::move(values);
    own->at = at;
    return own;
}

/// What the rival reaches where the likelihood is blunt. Its noise and floor are those of the sharp likelihood: seen
/// too low rather than too high.
double blunt_posterior(const Fit& rival, const LikelihoodContext& stage) {
    return log_likelihood(rival.trial, rival.predictions, stage) + log_belief(rival.unknowns, rival.values);
}

}  // namespace

double Fit::deviation(std::size_t unknown) const {
    return std::sqrt(covariance(static_cast<long>(unknown), static_cast<long>(unknown)));
}

const Unknown* Fit::find(const std::string& name, std::size_t* index) const {
    for (std::size_t i = 0; i < unknowns.size(); ++i)
        if (unknowns[i].name == name) {
            if (index) *index = i;
            return &unknowns[i];
        }
    return nullptr;
}

double log_posterior_at(const Trial& base, const std::vector<Unknown>& unknowns, std::vector<double> values,
                        const LikelihoodContext& context) {
    return state_at(base, unknowns, std::move(values), context).log_posterior;
}

std::vector<PredictionDerivative> derivatives_of(const Fit& fit, const LikelihoodContext& context) {
    return fit.derivatives ? fit.derivatives->values
                           : differentiate(fit.trial, fit.unknowns, fit.values, fit.predictions, context);
}

void restore_caches(Fit& fit, const LikelihoodContext& context) {
    if (fit.predictions.caches.empty() && !fit.predictions.spectra.empty())
        fit.predictions.caches = predict(fit.trial, context).caches;
}

void restore_derivatives(Fit& fit, const LikelihoodContext& context) {
    if (fit.derivatives || fit.predictions.spectra.empty()) return;
    fit.derivatives = kept(fit.unknowns, derivatives_of(fit, context), fit.predictions.spectra);
}

std::vector<double> means(const std::vector<Unknown>& unknowns) {
    std::vector<double> values;
    for (const Unknown& unknown : unknowns) values.push_back(unknown.mean);
    return values;
}

namespace {

/// One fit.
class Fitting {
  public:
    Fitting(const Trial& base, std::vector<Unknown> unknowns, const LikelihoodContext& context,
            const FitOptions& options)
        : base_(base), unknowns_(std::move(unknowns)), context_(context), options_(options) {}

    Fit run(std::vector<double> start) {
        state_ = state_at(base_, unknowns_, std::move(start), context_);
        if (!state_.possible()) return impossible();
        if (options_.near)
            slopes_ = {
                derivatives_near(*options_.near, state_.trial, unknowns_, state_.values, state_.predictions, context_),
                1, true};
        End end = options_.from_far ? from_far() : End::top;
        settle(unknowns_, context_, state_, options_.settings);
        if (options_.from_far && end != End::hopeless) choose_width();
        Normal normal;
        const double rival = options_.rival ? options_.rival->log_posterior - options_.room : kNoRival;
        if (end != End::hopeless)
            end = climb(base_, unknowns_, context_,
                        {.settings = options_.settings,
                         .least_gain = least_gain(),
                         .most = options_.iterations,
                         .rival = rival,
                         .between = options_.between},
                        damping_, state_, slopes_, iterations_, normal);
        if (end != End::top) normal = picture(end);
        return written(normal, end);
    }

  private:
    /// Blunted by 10 % there is one broad maximum; each stage brings the next within reach. The state stands where the
    /// sharp likelihood begins.
    End from_far() {
        const std::vector<Unknown> held = with_lines_held(unknowns_, state_.values);
        LikelihoodContext stage = context_;
        std::vector<double> floors = options_.stages;
        floors.push_back(context_.least_floor);
        const FitSettings& settings = options_.settings;
        End end = End::top;
        for (const double floor : floors) {
            stage.least_floor = floor;
            stage.every = floor > context_.least_floor ? std::max(kLikelihoodSettings.tempered_every, context_.every)
                                                       : context_.every;
            weigh(held, stage, state_);
            settle(held, stage, state_, options_.settings);
            ClimbOptions blunt{.settings = settings,
                               .least_gain = std::max(
                                   {options_.least_gain, settings.rung_gain, settings.rung_patience * unexplained()}),
                               .sharp = false,
                               .between = options_.between};
            blunt.rival = options_.rival ? blunt_posterior(*options_.rival, stage) - options_.room : kNoRival;
            blunt.most = floor > context_.least_floor ? options_.stage_iterations
                                                      : std::min(options_.iterations, settings.held_iterations);
            Normal unused;
            end = climb(base_, held, stage, blunt, damping_, state_, slopes_, iterations_, unused);
            if (end == End::top && state_.log_posterior + settings.dropped_behind_tempered < blunt.rival)
                end = End::hopeless;
            if (end == End::hopeless) break;
        }
        weigh(unknowns_, context_, state_);
        return end;
    }

    /// What the likelihood lies below its mean where the model is right: p²/2 for every bin of p channels that speaks
    /// by itself, half of that where neighbours overlap as those of Hann windows do.
    double unexplained() const {
        double chance = 0.0;
        for (const Observation& observation : *context_.observations) {
            const auto channels = static_cast<double>(observation.channels.size());
            if (!observation.scalar) chance += 0.25 * channels * channels * static_cast<double>(observation.bins());
        }
        return std::max(0.0, -state_.log_likelihood - chance);
    }

    double least_gain() const {
        return std::max({options_.least_gain, options_.patience * unexplained(),
                         context_.least_floor > 0.0 ? options_.settings.rung_gain : 0.0});
    }

    void choose_width() {
        const std::vector<ExpectedSpectra> before = state_.predictions.spectra;
        diagnosis::choose_width(base_, unknowns_, context_, options_.settings, state_);
        carry(slopes_.values, before, state_.predictions.spectra, context_);
        slopes_.carried = std::max(slopes_.carried, 1);
    }

    /// What is given up needs no derivatives of its own.
    Normal picture(End end) {
        if (slopes_.values.empty() || (end == End::tired && slopes_.carried > 0))
            slopes_ = {differentiate(state_.trial, unknowns_, state_.values, state_.predictions, context_), 0, true};
        return normal_equations(state_, unknowns_, slopes_.values, context_);
    }

    Fit impossible() {
        constexpr double kNever = -std::numeric_limits<double>::infinity();
        return Fit{.trial = std::move(state_.trial),
                   .unknowns = unknowns_,
                   .values = std::move(state_.values),
                   .log_likelihood = kNever,
                   .log_posterior = kNever,
                   .log_evidence = kNever};
    }

    Fit written(const Normal& normal, End end) {
        Fit result;
        const long size = static_cast<long>(unknowns_.size());
        Eigen::VectorXd deviations(size);
        for (long i = 0; i < size; ++i) deviations(i) = unknowns_[static_cast<std::size_t>(i)].deviation;
        const Eigen::MatrixXd scaled = deviations.asDiagonal() * normal.curvature * deviations.asDiagonal();
        const Eigen::LLT<Eigen::MatrixXd> factor(scaled);
        double log_determinant = 0.0;
        for (long i = 0; i < size; ++i) log_determinant += 2.0 * std::log(factor.matrixLLT()(i, i));
        result.covariance =
            deviations.asDiagonal() * factor.solve(Eigen::MatrixXd::Identity(size, size)) * deviations.asDiagonal();
        result.log_likelihood = state_.log_likelihood;
        result.log_posterior = state_.log_posterior;
        result.log_evidence = state_.log_posterior - 0.5 * log_determinant;
        result.information = normal.information;
        result.gradient = normal.gradient;
        result.iterations = iterations_;
        result.converged = end == End::top;
        if (end != End::hopeless && slopes_.carried == 0)
            result.derivatives = kept(unknowns_, std::move(slopes_.values), state_.predictions.spectra);
        result.trial = std::move(state_.trial);
        result.values = std::move(state_.values);
        result.predictions = std::move(state_.predictions);
        result.unknowns = std::move(unknowns_);
        return result;
    }

    const Trial& base_;
    std::vector<Unknown> unknowns_;
    const LikelihoodContext& context_;
    const FitOptions& options_;
    State state_;
    Slopes slopes_;
    double damping_ = options_.settings.first_damping;
    int iterations_ = 0;
};

}  // namespace

Approach approach(const Trial& base, const std::vector<Unknown>& unknowns, std::vector<double> start,
                  const Derivatives& near, const LikelihoodContext& context, double rival) {
    State state = state_at(base, unknowns, std::move(start), context);
    if (!state.possible()) return {-std::numeric_limits<double>::infinity(), std::move(state.values)};
    Slopes slopes{derivatives_near(near, state.trial, unknowns, state.values, state.predictions, context), 1, true};
    settle(unknowns, context, state);
    double damping = kFitSettings.first_damping;
    int iterations = 0;
    Normal unused;
    climb(base, unknowns, context, {.least_gain = kFitSettings.rung_gain, .most = 0, .rival = rival, .sharp = false},
          damping, state, slopes, iterations, unused);
    return {state.log_posterior, std::move(state.values)};
}

Fit fit(const Trial& base, std::vector<Unknown> unknowns, std::vector<double> start, const LikelihoodContext& context,
        const FitOptions& options) {
    return Fitting(base, std::move(unknowns), context, options).run(std::move(start));
}

}  // namespace railpem::diagnosis
