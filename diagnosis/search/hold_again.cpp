#include "diagnosis/search/hold_again.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "diagnosis/observations/held_distortion.hpp"

namespace railpem::diagnosis {

namespace {

/// nats behind the best within which a set may come forward under other forces; by judgement
constexpr double kWithinReach = 20.0;

/// logarithm of a contact's number over what was believed: what it distorts is a third off then, two deviations of that
/// belief
constexpr double kMostAway = 0.3;

bool is_of_contact(const EffectInstance& instance) {
    return element_of(*find_effect(instance.effect), instance) == Element::contact;
}

/// Values alone: predictions and derivatives were those of other forces.
Fit values_alone(const Fit& fit) {
    return {.trial = fit.trial, .unknowns = fit.unknowns, .values = fit.values};
}

}  // namespace

const FittedSet& best_of(const NamingResult& naming) {
    return naming.sets.empty() ? naming.retuned : naming.sets.front();
}

bool rests_on_held_forces(const NamingResult& naming, const BelievedCase& believed) {
    const FittedSet& best = best_of(naming);
    if (std::any_of(best.effects.begin(), best.effects.end(),
                    [](const Candidate& own) { return is_of_contact(own.instance); }))
        return true;
    return std::any_of(believed.uncertain.begin(), believed.uncertain.end(), [&](const BelievedNumber& number) {
        return element_of_key(number.key) == Element::contact &&
               std::abs(std::log(believed.access.get(best.fit.trial.numbers, number.key) / number.value)) > kMostAway;
    });
}

std::vector<Observation> held_again(const FittedSet& set, const BelievedCase& believed,
                                    const std::vector<Observation>& observations) {
    Trial trial = set.fit.trial;
    std::erase_if(trial.effects, is_of_contact);
    std::vector<Observation> held = observations;
    for (Observation& own : held) {
        if (own.scalar) continue;
        hold_contact_distortion(own, case_of(trial, believed, own));
        if (!own.coarse) continue;
        Observation coarse = *own.coarse;
        coarse.expectation.contacts = own.expectation.contacts;
        own.coarse = std::make_shared<const Observation>(std::move(coarse));
    }
    return held;
}

void fit_again(NamingResult& naming, const BelievedCase& believed, const LikelihoodContext& context) {
    const FitOptions near{.from_far = false};
    const auto again = [&](const FittedSet& set, const std::vector<Candidate>& effects) {
        return fit_set(believed, values_alone(set.fit), effects, set.released, {}, context, near);
    };
    std::vector<FittedSet> sets;
    const FittedSet best = best_of(naming);
    std::vector<Candidate> without = best.effects;
    std::erase_if(without, [](const Candidate& own) { return is_of_contact(own.instance); });
    if (without.size() < best.effects.size() && (!without.empty() || !best.released.empty()))
        sets.push_back(again(best, without));
    for (const FittedSet& own : naming.sets)
        if (own.score() > best.score() - kWithinReach) sets.push_back(again(own, own.effects));
    naming.retuned = again(naming.retuned, {});
    std::stable_sort(sets.begin(), sets.end(),
                     [](const FittedSet& a, const FittedSet& b) { return a.score() > b.score(); });
    naming.sets = std::move(sets);
    naming.dropped.clear();  // of other forces
    naming.left_by_best.clear();
    naming.left_by_retuned.clear();
}

}  // namespace railpem::diagnosis
