#include "diagnosis/hypotheses/correction_derivatives.hpp"

#include <algorithm>
#include <iterator>

#include "pem/threads.hpp"

namespace railpem::diagnosis {

namespace {

/// One unknown for each part (real and imaginary; three points where something is attached), which moves all nodes of
/// it alike.
std::vector<Unknown> whole_curves(const std::vector<Unknown>& freedom, std::size_t nodes) {
    const std::size_t parts = freedom.size() / nodes;
    std::vector<Unknown> whole(freedom.begin(), freedom.begin() + static_cast<long>(parts));
    for (std::size_t part = 0; part < parts; ++part)
        whole[part].set = [&freedom, parts, part](Trial& trial, double x) {
            for (std::size_t u = part; u < freedom.size(); u += parts) freedom[u].set(trial, x);
        };
    return whole;
}

/// Below the wheels a place also acts where its frequency is not: the lines of passing supports are made by the track
/// at rest.
bool acts_elsewhere(Element element) {
    return element == Element::rail || element == Element::pad || element == Element::support;
}

/// What a node weighs at the bins of an observation.
std::vector<double> node_weights(const CorrectionPlace& place, std::size_t part, const std::vector<double>& nodes,
                                 std::size_t node, const Observation& observation) {
    std::vector<double> weights(observation.bins());
    for (std::size_t bin = 0; bin < weights.size(); ++bin)
        weights[bin] = correction_weight(place, part, nodes, node, observation.frequency(bin));
    return weights;
}

/// The derivative with a node from that with the whole curve, on the bins where the node weighs anything: few of them.
PredictionDerivative at_node(const PredictionDerivative& whole, const std::vector<double>& weights,
                             std::size_t elements) {
    PredictionDerivative own{.observation = whole.observation};
    const auto weighs = [](double weight) { return weight != 0.0; };
    const auto first = std::find_if(weights.begin(), weights.end(), weighs);
    const auto last = std::find_if(weights.rbegin(), std::make_reverse_iterator(first), weighs).base();
    if (whole.values.empty()) return own;
    own.first_bin = static_cast<std::size_t>(first - weights.begin());
    own.values.reserve(static_cast<std::size_t>(last - first) * elements);
    for (auto weight = first; weight != last; ++weight) {
        const std::complex<double>* values =
            &whole.values[static_cast<std::size_t>(weight - weights.begin()) * elements];
        std::transform(values, values + elements, std::back_inserter(own.values),
                       [&](const std::complex<double>& value) { return *weight * value; });
    }
    return own;
}

}  // namespace

std::vector<PredictionDerivative> correction_derivatives(const Fit& fit, const CorrectionPlace& place,
                                                         const LikelihoodContext& context) {
    const std::vector<Observation>& observations = *context.observations;
    const std::vector<Unknown> freedom = correction_unknowns(place, observations);
    const auto is_scalar = [](const Observation& observation) { return observation.scalar.has_value(); };
    if ((acts_elsewhere(place.element) && !place.forces) ||
        std::any_of(observations.begin(), observations.end(), is_scalar))
        return differentiate(fit.trial, freedom, means(freedom), fit.predictions, context);
    const std::vector<double> nodes = correction_nodes(place, observations);
    const std::vector<Unknown> whole = whole_curves(freedom, nodes.size());
    const std::vector<PredictionDerivative> parts =
        differentiate(fit.trial, whole, means(whole), fit.predictions, context);
    std::vector<PredictionDerivative> result(parts.size() * nodes.size());
    pem::TeamFailure failure;  // without memory, say
#pragma omp parallel for schedule(dynamic, 1) num_threads(pem::thread_count(context.threads))
    for (std::size_t i = 0; i < result.size(); ++i)
        failure.guard([&] {
            const PredictionDerivative& part = parts[i / nodes.size()];
            const std::size_t node = i % nodes.size();
            const Observation& observation = observations[static_cast<std::size_t>(part.observation)];
            result[i] =
                at_node(part, node_weights(place, static_cast<std::size_t>(part.unknown), nodes, node, observation),
                        observation.channels.size() * observation.channels.size());
            result[i].unknown = static_cast<int>(node * whole.size()) + part.unknown;
        });
    failure.rethrow();
    return result;
}

}  // namespace railpem::diagnosis
