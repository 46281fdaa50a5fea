#include "diagnosis/fit/derivatives.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <exception>
#include <map>
#include <utility>

#include "diagnosis/fit/imperfection_derivatives.hpp"
#include "diagnosis/fit/irregularity_derivatives.hpp"
#include "diagnosis/model/reuse.hpp"
#include "pem/threads.hpp"

namespace railpem::diagnosis {

namespace {

/// √ of how the power of every channel changed, bin after bin; 1 where there was none.
std::vector<double> amplitude_ratios(const ExpectedSpectra& from, const ExpectedSpectra& to) {
    const std::size_t size = from.channels;
    std::vector<double> ratios(from.bins() * size, 1.0);
    for (std::size_t b = 0; b < from.bins(); ++b)
        for (std::size_t c = 0; c < size; ++c) {
            const std::size_t at = b * size * size + c * (size + 1);
            const double before = from.values[at].real(), now = to.values[at].real();
            if (before > 0.0 && now > 0.0) ratios[b * size + c] = std::sqrt(now / before);
        }
    return ratios;
}

void difference(const Trial& trial, const std::vector<Unknown>& unknowns, const std::vector<double>& values,
                const Predictions& predictions, const LikelihoodContext& context, PredictionDerivative& own) {
    const std::size_t o = static_cast<std::size_t>(own.observation), u = static_cast<std::size_t>(own.unknown);
    const Unknown& unknown = unknowns[u];
    if (unknown.kind == UnknownKind::calibration) {
        own.values = calibration_derivative(predictions[o], static_cast<std::size_t>(unknown.index));
        return;
    }
    const double step = values[u] + unknown.step <= unknown.high ? unknown.step : -unknown.step;
    Trial moved = trial;
    unknown.set(moved, values[u] + step);
    const ExpectedSpectra spectra = predict_like(predictions, moved, context, o, shared_with(trial, unknown));
    own.values.resize(spectra.values.size());
    for (std::size_t i = 0; i < spectra.values.size(); ++i)
        own.values[i] = (spectra.values[i] - predictions[o].values[i]) / step;
}

/// Of one observation: all of the irregularity, or all of what wheels meet alone.
void fill_together(const Trial& trial, const std::vector<Unknown>& unknowns, const Predictions& predictions,
                   const LikelihoodContext& context, const std::vector<std::size_t>& task,
                   std::vector<PredictionDerivative>& derivatives) {
    std::vector<const Unknown*> nodes;
    for (const std::size_t d : task) nodes.push_back(&unknowns[static_cast<std::size_t>(derivatives[d].unknown)]);
    const auto o = static_cast<std::size_t>(derivatives[task.front()].observation);
    std::vector<std::vector<std::complex<double>>> values =
        nodes.front()->kind == UnknownKind::met_alone ? met_alone_derivatives(trial, nodes, context, o, predictions)
                                                      : irregularity_derivatives(trial, nodes, context, o, predictions);
    for (std::size_t i = 0; i < task.size(); ++i) derivatives[task[i]].values = std::move(values[i]);
}

/// The derivatives that there are, still empty, and which of them are taken together: the irregularity's of an
/// observation where they can be (first: they take longest), what wheels meet alone, each of the others by itself.
std::vector<std::vector<std::size_t>> tasks_of(const Trial& trial, const std::vector<Unknown>& unknowns,
                                               const Predictions& predictions, const LikelihoodContext& context,
                                               std::vector<PredictionDerivative>& derivatives) {
    const std::vector<Observation>& observations = *context.observations;
    std::vector<bool> together;
    for (std::size_t o = 0; o < observations.size(); ++o)
        together.push_back(has_irregularity_derivatives(trial, context, o, predictions));
    std::vector<std::vector<std::size_t>> tasks(2 * observations.size());
    for (std::size_t u = 0; u < unknowns.size(); ++u)
        for (std::size_t o = 0; o < observations.size(); ++o) {
            if (!moves(unknowns[u], trial, observations[o], o)) continue;
            if (together[o] && unknowns[u].kind == UnknownKind::irregularity)
                tasks[o].push_back(derivatives.size());
            else if (!predictions.caches.empty() && unknowns[u].kind == UnknownKind::met_alone)
                tasks[observations.size() + o].push_back(derivatives.size());
            else
                tasks.push_back({derivatives.size()});
            derivatives.push_back({static_cast<int>(o), static_cast<int>(u), {}});
        }
    std::erase_if(tasks, [](const std::vector<std::size_t>& task) { return task.empty(); });
    return tasks;
}

bool is_of_retuning(const Unknown& unknown) {
    return unknown.kind != UnknownKind::effect && unknown.kind != UnknownKind::correction;
}

}  // namespace

std::vector<PredictionDerivative> differentiate(const Trial& trial, const std::vector<Unknown>& unknowns,
                                                const std::vector<double>& values, const Predictions& predictions,
                                                const LikelihoodContext& context) {
    std::vector<PredictionDerivative> derivatives;
    const std::vector<std::vector<std::size_t>> tasks = tasks_of(trial, unknowns, predictions, context, derivatives);
    std::exception_ptr failure;
#pragma omp parallel for schedule(dynamic, 1) num_threads(pem::thread_count(context.threads))
    for (std::size_t t = 0; t < tasks.size(); ++t) try {
            if (tasks[t].size() > 1)
                fill_together(trial, unknowns, predictions, context, tasks[t], derivatives);
            else
                difference(trial, unknowns, values, predictions, context, derivatives[tasks[t].front()]);
        } catch (...) {
#pragma omp critical(railpem_predict)
            failure = std::current_exception();
        }
    if (failure) std::rethrow_exception(failure);
    return derivatives;
}

namespace {

/// `known` with every channel's amplitude changed by its ratio; `scaled` may be `known`.
void scale(const PredictionDerivative& known, const std::vector<std::vector<double>>& ratios,
           const std::vector<ExpectedSpectra>& from, PredictionDerivative& scaled) {
    assert(known.first_bin == 0);
    const std::vector<double>& ratio = ratios[static_cast<std::size_t>(known.observation)];
    const std::size_t size = from[static_cast<std::size_t>(known.observation)].channels;
    if (size == 0 || known.values.empty()) return static_cast<void>(scaled.values = known.values);
    scaled.values.resize(known.values.size());
    for (std::size_t b = 0; b * size < ratio.size(); ++b)
        for (std::size_t j = 0; j < size; ++j) {
            const std::size_t at = (b * size + j) * size;
            for (std::size_t i = 0; i < size; ++i)
                scaled.values[at + i] = known.values[at + i] * (ratio[b * size + i] * ratio[b * size + j]);
        }
}

std::vector<std::vector<double>> ratios_of(const std::vector<ExpectedSpectra>& from,
                                           const std::vector<ExpectedSpectra>& to) {
    std::vector<std::vector<double>> ratios;
    for (std::size_t o = 0; o < from.size(); ++o) ratios.push_back(amplitude_ratios(from[o], to[o]));
    return ratios;
}

/// Derivatives of the unknowns that stand beside them, carried on.
std::vector<PredictionDerivative> carried_on(const std::vector<std::pair<const PredictionDerivative*, int>>& known,
                                             const std::vector<ExpectedSpectra>& from,
                                             const std::vector<ExpectedSpectra>& to, const LikelihoodContext& context) {
    const std::vector<std::vector<double>> ratios = ratios_of(from, to);
    std::vector<PredictionDerivative> result(known.size());
    std::exception_ptr failure;  // without memory, say
#pragma omp parallel for schedule(dynamic, 4) num_threads(pem::thread_count(context.threads))
    for (std::size_t d = 0; d < known.size(); ++d) try {
            result[d].observation = known[d].first->observation;
            result[d].unknown = known[d].second;
            scale(*known[d].first, ratios, from, result[d]);
        } catch (...) {
#pragma omp critical(railpem_predict)
            failure = std::current_exception();
        }
    if (failure) std::rethrow_exception(failure);
    return result;
}

}  // namespace

void carry(std::vector<PredictionDerivative>& derivatives, const std::vector<ExpectedSpectra>& from,
           const std::vector<ExpectedSpectra>& to, const LikelihoodContext& context) {
    const std::vector<std::vector<double>> ratios = ratios_of(from, to);
#pragma omp parallel for schedule(dynamic, 4) num_threads(pem::thread_count(context.threads))
    for (std::size_t d = 0; d < derivatives.size(); ++d) scale(derivatives[d], ratios, from, derivatives[d]);
}

std::vector<PredictionDerivative> derivatives_near(const Derivatives& known, const Trial& trial,
                                                   const std::vector<Unknown>& unknowns,
                                                   const std::vector<double>& values, const Predictions& predictions,
                                                   const LikelihoodContext& context) {
    std::map<std::string, std::vector<const PredictionDerivative*>> of_name;
    for (const std::string& name : known.names) of_name[name];
    for (const PredictionDerivative& own : known.values)
        of_name[known.names[static_cast<std::size_t>(own.unknown)]].push_back(&own);
    std::vector<std::pair<const PredictionDerivative*, int>> carried;  // and the unknown that it is of
    std::vector<Unknown> others;
    std::vector<double> other_values;
    std::vector<int> other_places;
    for (std::size_t u = 0; u < unknowns.size(); ++u) {
        const auto found = is_of_retuning(unknowns[u]) ? of_name.find(unknowns[u].name) : of_name.end();
        if (found == of_name.end()) {
            others.push_back(unknowns[u]);
            other_values.push_back(values[u]);
            other_places.push_back(static_cast<int>(u));
            continue;
        }
        for (const PredictionDerivative* own : found->second) carried.emplace_back(own, static_cast<int>(u));
    }
    std::vector<PredictionDerivative> result = carried_on(carried, known.at, predictions.spectra, context);
    for (PredictionDerivative& own : differentiate(trial, others, other_values, predictions, context)) {
        own.unknown = other_places[static_cast<std::size_t>(own.unknown)];
        result.push_back(std::move(own));
    }
    std::stable_sort(result.begin(), result.end(), [](const PredictionDerivative& a, const PredictionDerivative& b) {
        return a.unknown < b.unknown;
    });
    return result;
}

}  // namespace railpem::diagnosis
