#include "app/prove/detectability.hpp"

#include <algorithm>
#include <cmath>

#include "app/prove/effect_draws.hpp"

namespace railpem::app {

namespace {

struct Sighting {
    double strength;  ///< growing with the effect
    double value;     ///< of the parameter
    bool detected;
};

/// Distance from where the effect fades, or the inverse of a value that fades towards infinity.
double strength_of(const EffectDraw& draw, double value) {
    const double away = std::abs(value - draw.nothing);
    const bool is_factor = std::any_of(draw.parameters.begin(), draw.parameters.end(), [&](const DrawnParameter& own) {
        return own.name == draw.strength && own.mirror == DrawMirror::inverse;
    });
    if (is_factor) return std::abs(std::log(value));
    return draw.weak_when_large ? 1.0 / away : away;
}

/// The value from which on an effect is taken for detected with the fewest exceptions; NaN when all were detected or
/// none.
double threshold_of(const std::vector<Sighting>& ascending) {
    std::size_t detected_below = 0, missed_above = 0;
    for (const Sighting& sighting : ascending) missed_above += !sighting.detected;
    std::size_t fewest = missed_above, at = 0;
    for (std::size_t i = 0; i < ascending.size(); ++i) {
        detected_below += ascending[i].detected;
        missed_above -= !ascending[i].detected;
        if (detected_below + missed_above >= fewest) continue;
        fewest = detected_below + missed_above;
        at = i + 1;
    }
    return at == 0 || at == ascending.size() ? NAN : ascending[at].value;
}

void add_strengths(const EffectDraw& draw, std::vector<Sighting> sightings, Detectability& found) {
    std::sort(sightings.begin(), sightings.end(),
              [](const Sighting& a, const Sighting& b) { return a.strength < b.strength; });
    found.parameter = draw.strength;
    found.weak_when_large = draw.weak_when_large;
    for (const Sighting& sighting : sightings)
        if (!sighting.detected) found.largest_missed = sighting.value;
    const auto first = std::find_if(sightings.begin(), sightings.end(), [](const Sighting& s) { return s.detected; });
    if (first != sightings.end()) found.smallest_detected = first->value;
    found.threshold = threshold_of(sightings);
}

}  // namespace

std::vector<Detectability> detectability_of(const std::vector<ScoredTrial>& trials) {
    std::map<std::string, std::pair<Detectability, std::vector<Sighting>>> effects;
    for (const ScoredTrial& trial : trials) {
        if (trial.truth->hidden.size() != 1 || trial.judgement.claim == Claim::failed) continue;
        const std::string& id = trial.truth->hidden.front().id;
        auto& [found, sightings] = effects[id];
        found.effect = id;
        const bool detected = trial.judgement.claim != Claim::nothing;
        found.detected.count(detected);
        found.named.count(trial.judgement.right_effect);
        if (const double value = true_strength(*trial.truth); std::isfinite(value))
            sightings.push_back({strength_of(*find_draw(id), value), value, detected});
    }
    std::vector<Detectability> list;
    for (auto& [id, own] : effects) {
        own.first.smallest_detected = own.first.largest_missed = own.first.threshold = NAN;
        if (!own.second.empty()) add_strengths(*find_draw(id), own.second, own.first);
        list.push_back(own.first);
    }
    return list;
}

}  // namespace railpem::app
