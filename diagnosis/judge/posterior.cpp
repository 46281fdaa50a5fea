#include "diagnosis/judge/posterior.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace railpem::diagnosis {

namespace {

/// Scores far below the best carry no probability.
double weight_of(double score, double best) {
    return std::exp(std::max(-700.0, score - best));
}

double best_score(const NamingResult& naming, const Decision& decision) {
    double best = std::max(naming.retuned.score(), decision.unknown_score);
    for (const FittedSet& set : naming.sets) best = std::max(best, set.score());
    return best;
}

}  // namespace

std::vector<EffectSet> posterior_of(const NamingResult& naming, const Decision& decision) {
    const double best = best_score(naming, decision);
    double sum = weight_of(naming.retuned.score(), best) + weight_of(decision.unknown_score, best);
    for (const FittedSet& set : naming.sets) sum += weight_of(set.score(), best);
    std::vector<EffectSet> posterior;
    for (const FittedSet& set : naming.sets) posterior.push_back({labels_of(set), weight_of(set.score(), best) / sum});
    posterior.push_back({{}, weight_of(naming.retuned.score(), best) / sum});
    posterior.push_back({{"unknown"}, weight_of(decision.unknown_score, best) / sum});
    if (decision.other_friction > 0.0) {
        EffectSet& constant = posterior.front();  // the best set
        const EffectSet other{without_name_of_friction(constant.effects),
                              decision.other_friction * constant.probability};
        constant.probability -= other.probability;
        const auto same = std::find_if(posterior.begin(), posterior.end(),
                                       [&](const EffectSet& own) { return own.effects == other.effects; });
        if (same == posterior.end())
            posterior.push_back(other);
        else
            same->probability += other.probability;
    }
    std::stable_sort(posterior.begin(), posterior.end(),
                     [](const EffectSet& a, const EffectSet& b) { return a.probability > b.probability; });
    return posterior;
}

double probability_with(const NamingResult& naming, const Decision& decision,
                        const std::function<bool(const FittedSet&)>& has) {
    const double best = best_score(naming, decision);
    double with = 0.0, all = weight_of(naming.retuned.score(), best) + weight_of(decision.unknown_score, best);
    for (const FittedSet& set : naming.sets) {
        all += weight_of(set.score(), best);
        if (has(set)) with += weight_of(set.score(), best);
    }
    return with / all;
}

namespace {

/// How a set's probability is shared among its members: by what each brings beside the others, so that a small
/// correction of a large effect does not stand beside it as an equal.
std::vector<double> shares_of(const FittedSet& set, const NamingResult& naming) {
    std::vector<double> shares;
    double sum = 0.0;
    for (std::size_t i = 0; i < set.members(); ++i) {
        double without = naming.retuned.score();
        FittedSet rest{.effects = set.effects, .released = set.released};
        if (i < set.effects.size())
            rest.effects.erase(rest.effects.begin() + static_cast<long>(i));
        else
            rest.released.erase(rest.released.begin() + static_cast<long>(i - set.effects.size()));
        for (const std::vector<FittedSet>* sets : {&naming.sets, &naming.dropped})
            for (const FittedSet& other : *sets)
                if (contains(rest, other)) without = std::max(without, other.score());
        shares.push_back(std::max(1.0, set.score() - without));
        sum += shares.back();
    }
    for (double& share : shares) share /= sum;
    return shares;
}

/// What is left beside a set that does not stand has no name, and weighs as much as the set by what each explains: two
/// effects of the track gained 1333 nats of an absorber on an axle, beside them a free correction of the wheels would
/// have brought 2103 more, and the absorber sat where that helped.
double share_beside(const FittedSet& set, const NamingResult& naming, const PlaceStudy& places,
                    const Decision& decision) {
    if (decision.verdict != Verdict::unexplained || places.at_named.empty() || &set != &naming.sets.front()) return 0.0;
    const double left = std::max(0.0, places.at_named.front().nats);
    return left / (left + std::max(1.0, set.score() - naming.retuned.score()));
}

/// Where what is left sits beside members at `named`. Rigid ground has no free correction, pads answer for it: beside
/// ground that gives way what is left at the pads is the ground's, too (ground that changes along the line leaves 68 %
/// there).
Element beside_place(Element left, const std::vector<Element>& named) {
    const bool grounds = left == Element::pad &&
                         std::find(named.begin(), named.end(), Element::support) != named.end() &&
                         std::find(named.begin(), named.end(), Element::pad) == named.end();
    return grounds ? Element::support : left;
}

/// Of equal places that have a name the one that was found first, it led to the others; of those without one where a
/// free correction helps more.
bool goes_before(const PlaceEvidence& a, const PlaceEvidence& b) {
    constexpr double kNothing = 1e-9;
    if (a.probability != b.probability) return a.probability > b.probability;
    return a.probability < kNothing && a.nats > b.nats;
}

}  // namespace

std::vector<PlaceEvidence> place_probabilities(const NamingResult& naming, const PlaceStudy& places,
                                               const Decision& decision, const VerdictThresholds& thresholds) {
    std::map<Element, PlaceEvidence> found;
    for (const PlaceEvidence& place : places.at_retuned) found[place.element] = place;
    const double best = best_score(naming, decision);
    double sum = weight_of(decision.unknown_score, best);
    for (const FittedSet& set : naming.sets) sum += weight_of(set.score(), best);
    sum += weight_of(naming.retuned.score(), best);
    double unknown = weight_of(decision.unknown_score, best) / sum;
    for (const FittedSet& set : naming.sets) {
        // Where another thing sits, the name of what stands in for it does not say.
        if (is_too_strong(set) || needs_wrong_numbers(set, thresholds)) {
            unknown += weight_of(set.score(), best) / sum;
            continue;
        }
        const std::vector<Element> elements = elements_of(set, nullptr);
        const std::vector<double> shares = shares_of(set, naming);
        const double beside = share_beside(set, naming, places, decision),
                     probability = weight_of(set.score(), best) / sum;
        const auto add = [&](Element element, double share) {
            found[element].element = element, found[element].probability += probability * share;
        };
        for (std::size_t i = 0; i < elements.size(); ++i) add(elements[i], (1.0 - beside) * shares[i]);
        if (beside > 0.0) add(beside_place(places.at_named.front().element, elements), beside);
    }
    // What has no name sits where a free correction helps most.
    double highest = -1e300, shares = 0.0;
    for (const FittedSet& set : places.anonymous) highest = std::max(highest, set.score());
    for (const FittedSet& set : places.anonymous) shares += weight_of(set.score(), highest);
    for (const FittedSet& set : places.anonymous) {
        found[set.anonymous.front().element].element = set.anonymous.front().element;
        found[set.anonymous.front().element].probability += unknown * weight_of(set.score(), highest) / shares;
    }
    if (places.anonymous.empty() && !places.at_retuned.empty())
        found[places.at_retuned.front().element].probability += unknown;
    std::vector<PlaceEvidence> ranked;
    if (!naming.sets.empty())
        for (const Element element : elements_of(naming.sets.front(), nullptr))
            if (const auto own = found.find(element); own != found.end())
                ranked.push_back(own->second), found.erase(own);
    for (const auto& [element, evidence] : found) ranked.push_back(evidence);
    std::stable_sort(ranked.begin(), ranked.end(), goes_before);
    return ranked;
}

}  // namespace railpem::diagnosis
