#include "diagnosis/hypotheses/locate.hpp"

#include <algorithm>
#include <map>

#include "diagnosis/hypotheses/correction_derivatives.hpp"

namespace railpem::diagnosis {

std::vector<LocatedEvidence> locate(const Fit& fit, const LikelihoodContext& context) {
    const std::vector<CorrectionPlace> places = correction_places(*context.believed, *context.observations);
    std::vector<std::vector<Unknown>> freedoms;
    for (const CorrectionPlace& place : places) freedoms.push_back(correction_unknowns(place, *context.observations));
    const std::vector<FreedomPromise> promises = promises_of(
        fit, freedoms, context, [&](std::size_t i) { return correction_derivatives(fit, places[i], context); });
    std::map<Element, LocatedEvidence> best;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const auto found = best.find(places[i].element);
        if (found == best.end() || promises[i].nats > found->second.nats)
            best[places[i].element] = {places[i], promises[i].nats, promises[i]};
    }
    std::vector<LocatedEvidence> ranked;
    for (const auto& [element, own] : best) ranked.push_back(own);
    std::stable_sort(ranked.begin(), ranked.end(),
                     [](const LocatedEvidence& a, const LocatedEvidence& b) { return a.nats > b.nats; });
    return ranked;
}

bool is_evident_among(const std::vector<LocatedEvidence>& left, Element element, double chance) {
    constexpr double kEvident = 0.1;
    double most = chance / kEvident;
    for (const LocatedEvidence& own : left)
        if (own.place.element != Element::sensor) most = std::max(most, own.nats);
    return std::any_of(left.begin(), left.end(), [&](const LocatedEvidence& own) {
        return own.place.element == element && own.nats > kEvident * most;
    });
}

}  // namespace railpem::diagnosis
