#include "diagnosis/findings/rivals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "diagnosis/findings/friction_run.hpp"
#include "diagnosis/findings/separate.hpp"
#include "diagnosis/judge/posterior.hpp"

namespace railpem::diagnosis {

namespace {

constexpr std::size_t kMostRivals = 6;
constexpr std::size_t kSeparated = 3;  ///< rivals for which a test is sought

std::string why_not(const FittedSet& set, double behind, const Findings& found) {
    const std::vector<const FittedSet*>& credible = found.decision.credible;
    if (std::find(credible.begin(), credible.end(), &set) != credible.end()) return "nothing speaks against it so far";
    if (set.score() < found.naming.retuned.score() + gain_asked(set, found.thresholds))
        return "it explains no more than its own freedom costs";
    if (behind < found.thresholds.credible) return "nothing speaks against it so far";
    return "the data are less probable under it by e^" + std::to_string(static_cast<int>(behind));
}

Rival rival_of(const FittedSet& set, const FittedSet& best, const Findings& found) {
    Rival rival{.effects = labels_of(set),
                .nats_behind = best.score() - set.score(),
                .nats_held_out = set.held_out - found.naming.retuned.held_out};
    rival.instances.assign(set.fit.trial.effects.begin() + static_cast<long>(found.believed.effects.size()),
                           set.fit.trial.effects.end());
    for (const std::string& key : set.released) {
        std::size_t u = 0;
        set.fit.find(key, &u);
        rival.instances.push_back(wrong_number(key, std::exp(set.fit.values[u])));
    }
    rival.probability =
        probability_with(found.naming, found.decision, [&](const FittedSet& other) { return &other == &set; });
    rival.why_not = why_not(set, rival.nats_behind, found);
    return rival;
}

/// The best set's friction with a law that is not constant, and what it takes from the probability of the constant one.
Rival of_another_law(Rival& constant, const FrictionLaw& law, double probability, const std::string& test) {
    Rival other = constant;
    other.effects = without_name_of_friction(constant.effects);
    for (EffectInstance& instance : other.instances)
        if (is_friction(instance)) instance.effect = "unknown", instance.values.clear();
    other.why_not = fmt::format(
        "nothing speaks against it so far: the forces that friction has beside its damping have {:.2g} +- {:.2g} times "
        "the power that a constant force has where velocities are Gaussian, a constant one would seem to have {:.2g} "
        "here, and friction that sticks harder than it slides has more",
        law.power, law.deviation, law.expected);
    constant.probability *= 1.0 - probability;
    other.probability *= probability;
    other.would_separate = test;
    if (constant.would_separate.empty()) constant.would_separate = test;
    return other;
}

}  // namespace

std::vector<Rival> rivals_of(const Findings& found) {
    std::vector<Rival> rivals;
    if (found.naming.sets.empty()) return rivals;
    const FittedSet& best = found.naming.sets.front();
    const std::vector<const FittedSet*>& credible = found.decision.credible;
    const bool ambiguous = found.decision.verdict == Verdict::ambiguous;
    for (const FittedSet& set : found.naming.sets) {
        if (rivals.size() >= kMostRivals) break;
        if (ambiguous ? std::find(credible.begin(), credible.end(), &set) == credible.end()
                      : &set == found.decision.named)
            continue;
        Rival rival = rival_of(set, best, found);
        const FittedSet* other = &set != &best ? &best : credible.size() > 1 ? credible[1] : nullptr;
        if (other && rivals.size() < kSeparated)
            rival.would_separate = would_separate(*other, set, found.believed, found.observations);
        rivals.push_back(std::move(rival));
        if (&set == &best && found.decision.other_friction > 0.0)
            rivals.push_back(of_another_law(rivals.back(), *found.study.friction, found.decision.other_friction,
                                            would_tell_friction(best.fit, found.context)));
    }
    return rivals;
}

}  // namespace railpem::diagnosis
