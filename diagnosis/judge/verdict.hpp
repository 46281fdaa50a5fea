#pragma once
// From fitted sets to a verdict.

#include <functional>
#include <optional>

#include "diagnosis/hypotheses/naming_result.hpp"
#include "diagnosis/judge/constancy.hpp"
#include "diagnosis/judge/friction_law.hpp"
#include "diagnosis/judge/model_error.hpp"
#include "diagnosis/judge/probabilities.hpp"
#include "diagnosis/judge/verdict_kind.hpp"
#include "diagnosis/judge/verdict_thresholds.hpp"

namespace railpem::diagnosis {

/// Evidence of free corrections at the places of the structure.
struct PlaceStudy {
    std::vector<PlaceEvidence> at_retuned;  ///< ranked; what each would explain of what retuning leaves
    std::vector<PlaceEvidence> at_named;    ///< the same beside the named set: what is still missing
    std::vector<FittedSet> anonymous;       ///< fully fitted free corrections of the best places
    std::optional<FittedSet> belief_kept;   ///< of the best set, where it is_weighed_already(): fit_belief_kept()
    std::vector<std::string> unfounded;     ///< beliefs that would be given up, but for what no fit has seen
    /// where the unknown outdoes the best set: whether that explains something beside it
    bool named_stands = true;
    std::vector<ParameterByRecording> by_recording;  ///< of the best set
    std::optional<FrictionLaw> friction;             ///< of the best set, where it names friction
    double by_retuned = 0.0;                         ///< nats that the retuned case misses: missed_by()
    double by_named = 0.0;                           ///< and the best set
    /// by how much the levels of the retuned case and of the best set are off: repeated_level_db(), scalar_level_db()
    double retuned_level_db = 0.0, named_level_db = 0.0;
};

/// What the verdict is made of.
struct Decision {
    Verdict verdict = Verdict::consistent;
    const FittedSet* named = nullptr;        ///< the best set, if it deserves to be named
    std::vector<const FittedSet*> credible;  ///< named and its rivals
    /// probability that the friction of the best set, which would else be named, is of another law: a rival without a
    /// name; 0 where the recordings settle it
    double other_friction = 0.0;
    double unknown_score = -1e300;  ///< of the best anonymous correction
};

/// What a set explains, without what its fit holds.
FittedSet without_fit(const FittedSet& set);

/// Whether `larger` holds `smaller` and what it adds brings too little, hardly is there, or has the unseen part against
/// it.
bool adds_nothing(const FittedSet& smaller, const FittedSet& larger, const NamingResult& naming,
                  const VerdictThresholds& thresholds);

/// Takes out the sets that the unseen part speaks against, and those that say no more than a smaller one that was
/// fitted too: each further member has to bring `least_gain`, and what no fit has seen has to agree. Probabilities and
/// rivals are then those of the sets that are left, those that gain what they are asked (gain_asked()) first. True when
/// the first is another one then.
bool drop_superfluous(NamingResult& naming, const VerdictThresholds& thresholds);

/// Nats of log-evidence with prior by which a set has to be more probable than the retuned case to be named. Where it
/// adds no physics, retuning only had to stay too near a belief: VerdictThresholds::belief_gain.
double gain_asked(const FittedSet& set, const VerdictThresholds& thresholds);

/// Whether a set gains what it is asked by beliefs alone that it gives up, and retuning, which weighs them, has gone
/// the same way: to both what no fit has seen is as probable, chance apart. That says nothing of the belief then;
/// outdoes_kept() does. Not where there is nothing that no fit has seen.
bool is_weighed_already(const FittedSet& set, const NamingResult& naming, const VerdictThresholds& thresholds);

/// Whether a set that gives up beliefs explains what was fitted better than the case that keeps them by more than
/// chance, and what no fit has seen better at all.
bool outdoes_kept(const FittedSet& set, const FittedSet& belief_kept);

/// What is left of beliefs that were weighed already.
struct HeldBeliefs {
    /// the case that keeps what the best set gives up, where that was weighed already
    std::optional<FittedSet> of_best;
    std::vector<std::string> unfounded;  ///< labels of what was dropped
};

/// Drops the sets that could be named, or stand beside the name, by beliefs that were weighed already, and do not outdo
/// the case that keeps them: `keep` fits that (none where physics forbids it: dropped, too).
HeldBeliefs drop_unfounded_beliefs(NamingResult& naming, const VerdictThresholds& thresholds,
                                   const std::function<std::optional<FittedSet>(const FittedSet&)>& keep);

/// A member is smaller than anybody would speak of, or lies on the weak end of its range: it makes up for what a law
/// beside it is off by.
bool is_trifling(const FittedSet& set);

bool is_friction(const EffectInstance& instance);
bool names_friction(const FittedSet& set);

/// A set needs a parameter beyond the range of its physics, by more than chance and than what its own law may leave;
/// `nothing`: score of nothing added.
bool leans(const FittedSet& set, double nothing);

/// The released number of a set that would have to be further off than a wrong number is, by more than chance: that set
/// has no name. Empty: none.
std::string no_wrong_number(const FittedSet& set, double nothing);

/// Most nats that speak against one value in all recordings for a parameter of the best set.
double inconstancy(const PlaceStudy& study);

/// A number of the case ends further away from its belief than beside any right name: another thing stands behind the
/// set.
bool needs_wrong_numbers(const FittedSet& set, const VerdictThresholds& thresholds);

/// Whether a set may be named beside an unknown that outdoes it: within the range of its physics, and without wrong
/// numbers. `nothing`: score of the retuned case.
bool could_stand_beside(const FittedSet& set, double nothing, const VerdictThresholds& thresholds);

Decision decide(const NamingResult& naming, const PlaceStudy& places, const VerdictThresholds& thresholds);

/// Every member of `smaller` is in `larger`: the larger one does not contradict it, it only says more.
bool contains(const FittedSet& larger, const FittedSet& smaller);

/// It has every member of `smaller`, and more.
bool extends(const FittedSet& larger, const FittedSet& smaller);

/// Labels of a set's members, wrong numbers included.
std::vector<std::string> labels_of(const FittedSet& set);

/// The same where friction is of a law that has no name here: "unknown" in its place.
std::vector<std::string> without_name_of_friction(std::vector<std::string> labels);

/// Elements of a set's members.
std::vector<Element> elements_of(const FittedSet& set, const BelievedCase* believed);

}  // namespace railpem::diagnosis
