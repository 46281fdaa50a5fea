#include "diagnosis/judge/verdict.hpp"

#include <algorithm>
#include <cmath>

#include "diagnosis/fit/interval.hpp"
#include "diagnosis/judge/furthest_number.hpp"

namespace railpem::diagnosis {

namespace {

constexpr const char* kFriction = "suspension-friction";

/// nats by which the unseen part may speak against a belief that was only given up: the retuned
constexpr double kHeldOutChance = 2.0;
///< case sits at nearly the same value, so that the sign of so small a difference is chance

/// of its share, what is there repeats at least: 0.7 to 1.1 in marched records, names that were wrong 0.2 to 0.3
constexpr double kRepeated = 0.4;
constexpr double kRepeatDeviations = 1.5;  ///< of chance: a gain of n nats has the variance 2n
// The same where a belief is only given up: nothing was sought that chance could have offered, as distances of a comb
// are (sleeper passing six times as strong repeated 0.22 of 23 nats, 2.6 deviations too little).
constexpr double kBeliefDeviations = 2.5;

/// Members that retuning has not moved within a belief.
long new_to_retuning(const FittedSet& set) {
    return std::count_if(set.effects.begin(), set.effects.end(),
                         [](const Candidate& member) { return !find_effect(member.instance.effect)->retuned; });
}

bool adds_physics(const FittedSet& set) {
    return new_to_retuning(set) > 0;
}

/// The unseen part speaks against what `larger` adds, or does not repeat its share of it.
bool unseen_disagrees(const FittedSet& smaller, const FittedSet& larger, double unseen_share) {
    const bool only_given_up = new_to_retuning(larger) == new_to_retuning(smaller);
    const double repeated = larger.held_out - smaller.held_out;
    const double expected = unseen_share * std::max(0.0, larger.fit.log_likelihood - smaller.fit.log_likelihood);
    const double deviations = only_given_up ? kBeliefDeviations : kRepeatDeviations;
    const double least =
        std::max(0.0, std::min(kRepeated * expected, expected - deviations * std::sqrt(2.0 * expected)));
    return repeated < least - (only_given_up ? kHeldOutChance : 0.0);
}

/// nats that a set may gain beyond the range of its physics by chance: two deviations
constexpr double kLeaning = 2.0;

constexpr double kAtTheEnd = 0.01;  ///< of a range

/// Whether a strength lies within `reach` of the end of its range towards nothing: what is there would have to be
/// weaker than anything of its kind.
bool is_at_weak_end(const EffectParameter& parameter, double coordinate, double reach = 0.0) {
    if (!parameter.strength || (parameter.nothing > parameter.low && parameter.nothing < parameter.high)) return false;
    const double low = to_coordinate(parameter, parameter.low), high = to_coordinate(parameter, parameter.high);
    const double weak = parameter.nothing >= parameter.high ? high : low;
    return std::abs(coordinate - weak) < std::max(reach, kAtTheEnd * (high - low));
}

/// Whether the 90 % interval of a member's strength holds the weakest of its kind. Alone that may be there; beside
/// others, which are well known, it makes up for what their laws are off by: masses of the rail of 2 [2, 5] kg/m at 700
/// Hz and 2.5 [2, 19] kg/m at 30 Hz, far from all that was there, beside a flat loss factor and ballast.
bool has_one_that_hardly_is(const FittedSet& set) {
    if (static_cast<std::size_t>(set.fit.covariance.rows()) != set.fit.unknowns.size()) return false;
    for (std::size_t u = 0; u < set.fit.unknowns.size(); ++u)
        if (const EffectParameter* parameter = parameter_of(set.fit.unknowns[u]))
            if (is_at_weak_end(*parameter, set.fit.values[u], kNinety * set.fit.deviation(u))) return true;
    return false;
}

}  // namespace

bool contains(const FittedSet& larger, const FittedSet& smaller) {
    const auto has = [&](const Candidate& member) {
        return std::any_of(larger.effects.begin(), larger.effects.end(),
                           [&](const Candidate& own) { return same_variant(own.instance, member.instance); });
    };
    const auto released = [&](const std::string& key) {
        return std::find(larger.released.begin(), larger.released.end(), key) != larger.released.end();
    };
    return std::all_of(smaller.effects.begin(), smaller.effects.end(), has) &&
           std::all_of(smaller.released.begin(), smaller.released.end(), released);
}

bool extends(const FittedSet& larger, const FittedSet& smaller) {
    return larger.members() > smaller.members() && contains(larger, smaller);
}

bool is_trifling(const FittedSet& set) {
    for (std::size_t u = 0; u < set.fit.unknowns.size(); ++u)
        if (const EffectParameter* parameter = parameter_of(set.fit.unknowns[u]))
            if (std::abs(from_coordinate(*parameter, set.fit.values[u]) - parameter->nothing) < parameter->least ||
                is_at_weak_end(*parameter, set.fit.values[u]))
                return true;
    return false;
}

namespace {

/// of the nats that the others explain: what is left where an amplitude is a hundredth off
constexpr double kLeastAddition = 1e-4;

/// Nats that a further member has to bring beside `smaller`: more than what a law that is an approximation leaves for
/// anything to imitate, and than what no law is exact enough to leave out.
double least_addition(const FittedSet& smaller, double nothing, const VerdictThresholds& thresholds) {
    if (is_approximate(smaller)) return nats_left(smaller, nothing, thresholds.least_gain);
    return std::max(thresholds.least_gain, kLeastAddition * (smaller.score() - nothing));
}

}  // namespace

bool adds_nothing(const FittedSet& smaller, const FittedSet& larger, const NamingResult& naming,
                  const VerdictThresholds& thresholds) {
    return extends(larger, smaller) &&
           (larger.score() < smaller.score() + least_addition(smaller, naming.retuned.score(), thresholds) ||
            unseen_disagrees(smaller, larger, naming.unseen_share) || (is_trifling(larger) && !is_trifling(smaller)) ||
            (has_one_that_hardly_is(larger) && !has_one_that_hardly_is(smaller)));
}

namespace {

bool says_as_much(const FittedSet& smaller, const FittedSet& larger, const NamingResult& naming,
                  const VerdictThresholds& thresholds) {
    const double nothing = naming.retuned.score();
    return adds_nothing(smaller, larger, naming, thresholds) ||
           (extends(larger, smaller) && leans(larger, nothing) && !leans(smaller, nothing));
}

/// The same hypothesis, fitted from another start.
bool is_the_same(const FittedSet& first, const FittedSet& second) {
    return first.members() == second.members() && contains(first, second) && contains(second, first);
}

bool only_sensors(const FittedSet& set) {
    const auto elements = elements_of(set, nullptr);
    return set.released.empty() && !elements.empty() &&
           std::all_of(elements.begin(), elements.end(), [](Element element) { return element == Element::sensor; });
}

}  // namespace

// An approximation may be driven beyond the range by what it leaves: fasteners that carry nothing at all lie on the end
// of theirs. Not so what would be stronger than its physics can be by more than its law gets wrong: a play of 0.13 mm
// was called a contact five times as nonlinear as Hertz's, which is as much as there is.
bool leans(const FittedSet& set, double nothing) {
    return nats_beyond_range(set) >
           (is_approximate(set) && !is_too_strong(set) ? nats_left(set, nothing, kLeaning) : kLeaning);
}

double gain_asked(const FittedSet& set, const VerdictThresholds& thresholds) {
    return adds_physics(set) ? thresholds.least_gain : thresholds.belief_gain;
}

bool is_weighed_already(const FittedSet& set, const NamingResult& naming, const VerdictThresholds& thresholds) {
    return naming.unseen_share > 0.0 && !adds_physics(set) &&
           set.score() > naming.retuned.score() + gain_asked(set, thresholds) &&
           set.held_out < naming.retuned.held_out + kHeldOutChance;
}

bool outdoes_kept(const FittedSet& set, const FittedSet& belief_kept) {
    return set.fit.log_likelihood > belief_kept.fit.log_likelihood + kHeldOutChance &&
           set.held_out > belief_kept.held_out;
}

HeldBeliefs drop_unfounded_beliefs(NamingResult& naming, const VerdictThresholds& thresholds,
                                   const std::function<std::optional<FittedSet>(const FittedSet&)>& keep) {
    HeldBeliefs held;
    for (std::size_t i = 0;
         i < naming.sets.size() && naming.sets[i].score() > naming.sets.front().score() - thresholds.credible;) {
        const FittedSet& set = naming.sets[i];
        std::optional<FittedSet> kept;
        if (is_weighed_already(set, naming, thresholds)) {
            kept = keep(set);
            if (!kept || !outdoes_kept(set, *kept)) {
                for (const std::string& label : labels_of(set)) held.unfounded.push_back(label);
                naming.dropped.push_back(without_fit(set));
                naming.sets.erase(naming.sets.begin() + static_cast<long>(i));
                continue;
            }
        }
        if (i == 0) held.of_best = std::move(kept);
        ++i;
    }
    return held;
}

std::string no_wrong_number(const FittedSet& set, double nothing) {
    return leans(set, nothing) ? number_beyond_range(set) : "";
}

std::vector<std::string> labels_of(const FittedSet& set) {
    std::vector<std::string> labels;
    for (const Candidate& member : set.effects) labels.push_back(member.instance.effect);
    for (std::size_t i = 0; i < set.released.size(); ++i) labels.push_back("parameter-error");
    return labels;
}

std::vector<std::string> without_name_of_friction(std::vector<std::string> labels) {
    std::replace(labels.begin(), labels.end(), std::string(kFriction), std::string("unknown"));
    return labels;
}

std::vector<Element> elements_of(const FittedSet& set, const BelievedCase*) {
    std::vector<Element> elements;
    for (const Candidate& member : set.effects)
        elements.push_back(element_of(*find_effect(member.instance.effect), member.instance));
    for (const std::string& key : set.released) elements.push_back(element_of_key(key));
    return elements;
}

bool is_friction(const EffectInstance& instance) {
    return instance.effect == kFriction;
}

bool names_friction(const FittedSet& set) {
    return std::any_of(set.effects.begin(), set.effects.end(),
                       [](const Candidate& member) { return is_friction(member.instance); });
}

FittedSet without_fit(const FittedSet& set) {
    FittedSet own{
        .effects = set.effects, .released = set.released, .log_prior = set.log_prior, .held_out = set.held_out};
    own.fit.log_evidence = set.fit.log_evidence;
    return own;
}

bool drop_superfluous(NamingResult& naming, const VerdictThresholds& thresholds) {
    std::vector<FittedSet> kept;
    bool first = false;
    for (std::size_t i = 0; i < naming.sets.size(); ++i) {
        const FittedSet& set = naming.sets[i];
        const auto here = naming.sets.begin() + static_cast<long>(i);
        const bool superfluous =
            (set.members() == 1 && is_trifling(set)) || unseen_disagrees(naming.retuned, set, naming.unseen_share) ||
            std::any_of(naming.sets.begin(), here, [&](const FittedSet& better) { return is_the_same(better, set); }) ||
            std::any_of(naming.sets.begin(), naming.sets.end(),
                        [&](const FittedSet& own) { return says_as_much(own, set, naming, thresholds); });
        if (!superfluous) {
            kept.push_back(set);
            continue;
        }
        first = first || i == 0;
        naming.dropped.push_back(without_fit(set));
    }
    naming.sets = std::move(kept);
    // Physics that does not bring what it would need does not stand before a number that does.
    const auto gains = [&](const FittedSet& set) {
        return set.score() > naming.retuned.score() + gain_asked(set, thresholds);
    };
    first = first || (!naming.sets.empty() && !gains(naming.sets.front()) &&
                      std::any_of(naming.sets.begin(), naming.sets.end(), gains));
    std::stable_partition(naming.sets.begin(), naming.sets.end(), gains);
    return first;
}

double inconstancy(const PlaceStudy& study) {
    double most = 0.0;
    for (const ParameterByRecording& own : study.by_recording) most = std::max(most, own.nats);
    return most;
}

namespace {

/// Whether the levels of a set are near those that were recorded: statistics apart, that is what explaining means.
/// Friction is a law of the level and is left out: linearised, it misses up to 4 dB of what the rest of a suspension
/// lets through.
bool follows(const FittedSet& set, const PlaceStudy& places, const VerdictThresholds& thresholds) {
    return names_friction(set) || places.named_level_db <= thresholds.level_db;
}

}  // namespace

bool needs_wrong_numbers(const FittedSet& set, const VerdictThresholds& thresholds) {
    double tolerances = thresholds.number_tolerances;
    for (const Candidate& member : set.effects)
        tolerances = std::max(tolerances, find_effect(member.instance.effect)->bends_numbers);
    return furthest_number(set) > tolerances;
}

// Preload on the end of its range, with numbers far off, was named beside a play of the fastenings that outdid it by
// 170 nats (`full_226830439` in docs/proof, trial 103).
bool could_stand_beside(const FittedSet& set, double nothing, const VerdictThresholds& thresholds) {
    return !leans(set, nothing) && !needs_wrong_numbers(set, thresholds);
}

Decision decide(const NamingResult& naming, const PlaceStudy& places, const VerdictThresholds& thresholds) {
    Decision decision;
    for (const FittedSet& set : places.anonymous)
        decision.unknown_score = std::max(decision.unknown_score, set.score());
    const double nothing = naming.retuned.score();
    const FittedSet* best = naming.sets.empty() ? nullptr : &naming.sets.front();
    const bool gains = best && best->score() > nothing + gain_asked(*best, thresholds) &&
                       !unseen_disagrees(naming.retuned, *best, naming.unseen_share);
    const bool has_name = gains && no_wrong_number(*best, nothing).empty();
    const bool stands_beside = places.named_stands && best && could_stand_beside(*best, nothing, thresholds);
    if (has_name && (decision.unknown_score < best->score() + thresholds.anonymous || stands_beside)) {
        decision.named = best;
        for (const FittedSet& set : naming.sets)
            if (&set == best ||
                (set.score() > std::max(best->score() - thresholds.credible, nothing + thresholds.belief_gain) &&
                 !contains(set, *best) && !leans(set, nothing)))
                decision.credible.push_back(&set);
    }
    const double residual_named = places.at_named.empty() ? 0.0 : places.at_named.front().nats;
    const double residual_retuned = places.at_retuned.empty() ? 0.0 : places.at_retuned.front().nats;
    if (gains && decision.unknown_score < best->score() + thresholds.anonymous &&
        residual_named < nats_left(*best, nothing, thresholds.residual) && !leans(*best, nothing) &&
        places.by_named <= misfit_left(*best, nothing, thresholds.residual) &&
        inconstancy(places) < nats_left(*best, nothing, thresholds.residual) &&
        !needs_wrong_numbers(*best, thresholds) && follows(*best, places, thresholds) &&
        !(places.friction && is_another(*places.friction))) {
        if (places.friction && is_open(*places.friction))
            decision.other_friction = probability_of_another(*places.friction);
        decision.verdict = decision.credible.size() > 1 || decision.other_friction > 0.0 ? Verdict::ambiguous
                           : only_sensors(*best)                                         ? Verdict::recording_fault
                                                                                         : Verdict::explained;
    } else if (gains)
        decision.verdict = Verdict::unexplained;
    else
        decision.verdict = std::max(decision.unknown_score - nothing, residual_retuned) > thresholds.residual ||
                                   places.by_retuned > thresholds.residual ||
                                   places.retuned_level_db > thresholds.level_db
                               ? Verdict::unexplained
                               : Verdict::consistent;
    return decision;
}

}  // namespace railpem::diagnosis
