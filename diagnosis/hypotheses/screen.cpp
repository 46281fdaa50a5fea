#include "diagnosis/hypotheses/screen.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "diagnosis/observations/shows.hpp"
#include "parameters/parameter_error.hpp"
#include "pem/threads.hpp"

namespace railpem::diagnosis {

namespace {

constexpr std::size_t kBatch = 60;  ///< candidates whose derivatives are held in memory at a time

/// Differences of the predictions with and without each candidate; empty where a candidate is impossible.
std::vector<PredictionDerivative> directions(const Fit& fit, const std::vector<Candidate>& candidates,
                                             std::size_t first, std::size_t count, const LikelihoodContext& context) {
    const std::vector<Observation>& observations = *context.observations;
    std::vector<PredictionDerivative> result(count * observations.size());
#pragma omp parallel for schedule(dynamic, 1) num_threads(pem::thread_count(context.threads))
    for (std::size_t i = 0; i < result.size(); ++i) {
        const std::size_t c = i / observations.size(), o = i % observations.size();
        PredictionDerivative& own = result[i];
        own.observation = static_cast<int>(o);
        own.unknown = static_cast<int>(fit.unknowns.size() + c);
        if (!could_show(observations[o], *find_effect(candidates[first + c].probe.effect))) continue;
        Trial trial = fit.trial;
        trial.effects.push_back(candidates[first + c].probe);
        try {
            const ExpectedSpectra with =
                predict_like(fit.predictions, trial, context, o, shared_with_probe(trial, candidates[first + c].probe));
            own.values.resize(with.values.size());
            for (std::size_t k = 0; k < with.values.size(); ++k)
                own.values[k] = (with.values[k] - fit.predictions[o].values[k]);
        } catch (const parameters::ParameterError&) {
            own.values.assign(fit.predictions[o].values.size(), 0.0);
        }
    }
    return result;
}

std::vector<Unknown> with_placeholders(const Fit& fit, std::size_t count) {
    std::vector<Unknown> all = fit.unknowns;
    for (std::size_t i = 0; i < count; ++i) all.push_back({.kind = UnknownKind::effect, .name = "direction"});
    return all;
}

/// Information of the fit's unknowns with their beliefs.
Eigen::MatrixXd curvature_of(const Fit& fit, const Eigen::MatrixXd& information) {
    const long own = static_cast<long>(fit.unknowns.size());
    Eigen::MatrixXd curvature = information.topLeftCorner(own, own);
    for (long i = 0; i < own; ++i)
        curvature(i, i) += 1.0 / (fit.unknowns[static_cast<std::size_t>(i)].deviation *
                                  fit.unknowns[static_cast<std::size_t>(i)].deviation);
    return curvature;
}

}  // namespace

std::vector<Promise> screen(const Fit& fit, const std::vector<Candidate>& candidates,
                            const LikelihoodContext& context) {
    // those of the fit's own unknowns come first
    std::vector<PredictionDerivative> derivatives = derivatives_of(fit, context);
    const std::size_t nuisance = derivatives.size();
    const long own = static_cast<long>(fit.unknowns.size());
    std::vector<Promise> promises;
    for (std::size_t first = 0; first < candidates.size(); first += kBatch) {
        const std::size_t count = std::min(kBatch, candidates.size() - first);
        derivatives.resize(nuisance);
        for (PredictionDerivative& direction : directions(fit, candidates, first, count, context))
            derivatives.push_back(std::move(direction));
        const LikelihoodSlope slope =
            likelihood_slope(fit.trial, with_placeholders(fit, count), fit.predictions, derivatives, context);
        const Eigen::LDLT<Eigen::MatrixXd> factor(curvature_of(fit, slope.information));
        const Eigen::MatrixXd cross = slope.information.topRightCorner(own, static_cast<long>(count));
        const Eigen::MatrixXd projected = factor.solve(cross);
        for (long c = 0; c < static_cast<long>(count); ++c) {
            const double information = slope.information(own + c, own + c) - cross.col(c).dot(projected.col(c));
            const double gradient = slope.gradient(own + c) - projected.col(c).dot(fit.gradient);
            Promise promise{.candidate = first + static_cast<std::size_t>(c), .move = -projected.col(c)};
            if (information > 1e-9 * slope.information(own + c, own + c) && information > 0.0) {
                promise.strength = gradient / information;
                if (promise.strength > 0.0 || candidates[promise.candidate].two_sided)
                    promise.gain = 0.5 * gradient * gradient / information;
            }
            promises.push_back(promise);
        }
    }
    std::stable_sort(promises.begin(), promises.end(),
                     [](const Promise& a, const Promise& b) { return a.gain > b.gain; });
    return promises;
}

namespace {

/// Information and gradient of a freedom with the fit's unknowns projected out.
struct Projected {
    Eigen::MatrixXd nuisance;  ///< of the fit's unknowns, by which its own are followed
    Eigen::MatrixXd information;
    Eigen::VectorXd gradient;
};

Projected projected(const Fit& fit, const LikelihoodSlope& slope, const Eigen::LDLT<Eigen::MatrixXd>& factor,
                    long count, long first) {
    const Eigen::MatrixXd cross = slope.information.block(0, first, static_cast<long>(fit.unknowns.size()), count);
    Projected own{.nuisance = factor.solve(cross), .information = {}, .gradient = {}};
    own.information = slope.information.block(first, first, count, count) - cross.transpose() * own.nuisance;
    own.gradient = slope.gradient.segment(first, count) - own.nuisance.transpose() * fit.gradient;
    return own;
}

/// With the beliefs of those of its unknowns that are `kept`; the others stay where they are.
FreedomPromise promise_of(const Projected& all, const std::vector<Unknown>& freedom, const std::vector<long>& kept) {
    const long count = static_cast<long>(kept.size()), whole = all.gradient.size();
    Eigen::VectorXd deviation(count);
    for (long i = 0; i < count; ++i)
        deviation(i) = freedom[static_cast<std::size_t>(kept[static_cast<std::size_t>(i)])].deviation;
    const Eigen::MatrixXd scaled = Eigen::MatrixXd::Identity(count, count) +
                                   deviation.asDiagonal() * all.information(kept, kept) * deviation.asDiagonal();
    const Eigen::LLT<Eigen::MatrixXd> factor(scaled);
    const Eigen::VectorXd right = deviation.asDiagonal() * all.gradient(kept), solved = factor.solve(right);
    FreedomPromise promise{
        .values = Eigen::VectorXd::Zero(whole), .covariance = Eigen::MatrixXd::Zero(whole, whole), .move = {}};
    promise.values(kept) = deviation.asDiagonal() * solved;
    promise.move = -all.nuisance * promise.values;
    promise.covariance(kept, kept) =
        deviation.asDiagonal() * factor.solve(Eigen::MatrixXd::Identity(count, count)) * deviation.asDiagonal();
    promise.nats = 0.5 * right.dot(solved);
    for (long i = 0; i < count; ++i) promise.nats -= std::log(factor.matrixLLT()(i, i));
    return promise;
}

/// One freedom's promise from the slope of fit and freedoms together, its unknowns beginning at `first`. What cannot
/// fall below where it stands, a power, and would, stays.
FreedomPromise promise_from(const Fit& fit, const LikelihoodSlope& slope, const Eigen::LDLT<Eigen::MatrixXd>& factor,
                            const std::vector<Unknown>& freedom, long first) {
    const Projected all = projected(fit, slope, factor, static_cast<long>(freedom.size()), first);
    std::vector<long> kept(freedom.size());
    std::iota(kept.begin(), kept.end(), 0L);
    while (true) {
        FreedomPromise promise = promise_of(all, freedom, kept);
        const auto would_fall = [&](long i) {
            const Unknown& own = freedom[static_cast<std::size_t>(i)];
            return own.low >= own.mean && promise.values(i) < 0.0;
        };
        if (std::erase_if(kept, would_fall) == 0) return promise;
    }
}

}  // namespace

std::vector<FreedomPromise> promises_of(const Fit& fit, const std::vector<std::vector<Unknown>>& freedoms,
                                        const LikelihoodContext& context, const FreedomDerivatives& given) {
    // those of the fit's own unknowns come first
    std::vector<PredictionDerivative> derivatives = derivatives_of(fit, context);
    const std::size_t nuisance = derivatives.size();
    std::vector<FreedomPromise> promises;
    // several side by side: the fit's own columns are whitened once for all of them
    while (promises.size() < freedoms.size()) {
        std::vector<Unknown> side_by_side, all = fit.unknowns;
        std::vector<long> first;
        derivatives.resize(nuisance);
        for (std::size_t i = promises.size();
             i < freedoms.size() && (first.empty() || side_by_side.size() + freedoms[i].size() <= kBatch); ++i) {
            first.push_back(static_cast<long>(all.size() + side_by_side.size()));
            for (PredictionDerivative& derivative :
                 given ? given(i)
                       : differentiate(fit.trial, freedoms[i], means(freedoms[i]), fit.predictions, context)) {
                derivative.unknown += static_cast<int>(first.back());
                derivatives.push_back(std::move(derivative));
            }
            side_by_side.insert(side_by_side.end(), freedoms[i].begin(), freedoms[i].end());
        }
        all.insert(all.end(), side_by_side.begin(), side_by_side.end());
        const LikelihoodSlope slope = likelihood_slope(fit.trial, all, fit.predictions, derivatives, context);
        const Eigen::LDLT<Eigen::MatrixXd> factor(curvature_of(fit, slope.information));
        for (const long begin : first)
            promises.push_back(promise_from(fit, slope, factor, freedoms[promises.size()], begin));
    }
    return promises;
}

double release_gain(const Fit& fit, std::size_t unknown, double wide) {
    const Unknown& own = fit.unknowns[unknown];
    const double variance = fit.covariance(static_cast<long>(unknown), static_cast<long>(unknown));
    const double belief = own.deviation * own.deviation;
    const double precision = 1.0 / variance - 1.0 / belief;  // what the data alone say of it
    if (precision <= 1e-9 / belief) return 0.0;
    const double data = 1.0 / precision;
    const double distance = data * (fit.values[unknown] / variance - own.mean / belief) - own.mean;
    const double narrow_sum = data + belief, wide_sum = data + wide * wide;
    return 0.5 * std::log(narrow_sum / wide_sum) + 0.5 * distance * distance * (1.0 / narrow_sum - 1.0 / wide_sum);
}

}  // namespace railpem::diagnosis
