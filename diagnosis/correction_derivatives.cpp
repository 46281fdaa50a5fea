#include "diagnosis/correction_derivatives.hpp"

#include <algorithm>

namespace railpem::diagnosis {

namespace {

/// One unknown for each part (real and imaginary; three points where something is attached), which moves all nodes of it alike.
std::vector<Unknown> whole_curves(const std::vector<Unknown>& freedom, std::size_t nodes) {
    const std::size_t parts = freedom.size() / nodes;
    std::vector<Unknown> whole(freedom.begin(), freedom.begin() + static_cast<long>(parts));
    for (std::size_t part = 0; part < parts; ++part)
        whole[part].set = [&freedom, parts, part](Trial& trial, double x) {
            for (std::size_t u = part; u < freedom.size(); u += parts) freedom[u].set(trial, x);
        };
    return whole;
}

/// Below the wheels a place also acts where its frequency is not: the lines of passing supports are made by the track at rest.
bool acts_elsewhere(Element element) { return element == Element::rail || element == Element::pad || element == Element::support; }

}  // namespace

std::vector<PredictionDerivative> correction_derivatives(const Fit& fit, const CorrectionPlace& place, const LikelihoodContext& context) {
    const std::vector<Observation>& observations = *context.observations;
    const std::vector<Unknown> freedom = correction_unknowns(place, observations);
    const auto is_scalar = [](const Observation& observation) { return observation.scalar.has_value(); };
    if ((acts_elsewhere(place.element) && !place.forces) || std::any_of(observations.begin(), observations.end(), is_scalar)) return differentiate(fit.trial, freedom, means(freedom), fit.predictions, context);
    const std::vector<double> nodes = correction_nodes(place, observations);
    const std::vector<Unknown> whole = whole_curves(freedom, nodes.size());
    std::vector<PredictionDerivative> result;
    for (const PredictionDerivative& part : differentiate(fit.trial, whole, means(whole), fit.predictions, context))
        for (std::size_t node = 0; node < nodes.size(); ++node) {
            const Observation& observation = observations[static_cast<std::size_t>(part.observation)];
            const std::size_t size = observation.channels.size() * observation.channels.size();
            PredictionDerivative own{part.observation, static_cast<int>(node * whole.size()) + part.unknown, std::vector<std::complex<double>>(part.values.size(), 0.0)};
            for (std::size_t bin = 0; bin < observation.bins(); ++bin) {
                const double weight = correction_weight(place, static_cast<std::size_t>(part.unknown), nodes, node, observation.frequency(bin));
                for (std::size_t i = bin * size; weight != 0.0 && i < (bin + 1) * size; ++i) own.values[i] = weight * part.values[i];
            }
            result.push_back(std::move(own));
        }
    return result;
}

}  // namespace railpem::diagnosis
