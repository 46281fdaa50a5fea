#pragma once
// The fits of which the search for what was left out consists.

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "diagnosis/hypotheses/naming_result.hpp"
#include "diagnosis/hypotheses/worth_refitting.hpp"
#include "diagnosis/search/from_afar.hpp"
#include "diagnosis/search/naming_options.hpp"

namespace railpem::diagnosis {

/// Thrown between steps when somebody wants to end the search.
struct Interrupted {};

/// Fits sets of effects and released numbers, and keeps all of them in a NamingResult. Every fit may throw Interrupted;
/// what was fitted before stays.
class SetTrials {
  public:
    /// All arguments have to outlive this; `result.candidates` may grow while it is used.
    SetTrials(const BelievedCase& believed, const LikelihoodContext& context, const NamingOptions& options,
              NamingResult& result);

    /// Whether the likelihood is blunted by a floor: such fits begin near and stay near.
    bool is_blunt() const;

    /// Reports what is being done and the share done; throws Interrupted when asked to end.
    void say(const std::string& what, double share) const;

    /// Fits the believed case with nothing added.
    void retune();

    /// Fits one set from a fit near it. `far`: with the likelihood blunted first, in few steps of each stage; else it
    /// is given up where it cannot come near the most probable so far, and `ahead` nats beyond it.
    const FittedSet& try_set(const Fit& near, std::vector<Candidate> members, std::vector<std::string> released,
                             double share, bool far = false, double ahead = 0.0);

    /// Fits the best start of a variant beside `members`; the best two distances of a comb of lines (climbed_apart()),
    /// and also from the best of the distances that share lines with it. The better. A comb that gains hardly more over
    /// `near` than its decoys (comb_decoys()) is a noise of its shape, and cannot be: its score is −∞. `ahead` as
    /// above.
    const FittedSet& try_starts(const Fit& near, const Starts& starts, const std::vector<Candidate>& members,
                                const std::vector<std::string>& released, double share, double ahead = 0.0);

    /// A fit of the best set of so many members that ran out of steps goes on: what it has left to gain would be put
    /// down to the next member.
    void finish_best(std::size_t members);

    /// The best set without each of its members in turn: one grown member by member may hold some that a later one has
    /// made needless, and what each of the others explains is what it brings beside the rest. The size of what is then
    /// the best set, where that is smaller; 0 otherwise, and where this set was asked about before.
    std::size_t prune();

    /// Pairs in which `second` stays and the first of the set `from`, a single, is replaced by the other promising
    /// singles; `brought`: nats by which the second has improved on the single.
    void swap_first(const Candidate& second, const FittedSet& from, double brought, double share);

    /// Takes out what holds `smaller` and brings less than `least` nats beside it, so that nothing is looked for beside
    /// that. Like drop_superfluous().
    void drop_beside(const FittedSet& smaller, double least);

    /// Takes out what adds nothing to a smaller set (adds_nothing()), so that nothing is looked for beside it. Like
    /// drop_superfluous().
    void drop_needless();

    /// The best set of so many members; none: nullptr.
    const FittedSet* best(std::size_t members) const;

    /// The n-th best variant of an effect as a single, better than the retuned case; nullptr: there are fewer.
    const FittedSet* single(std::size_t nth) const;

    /// The best set if it is better than the retuned case, which stands for nothing added; else that.
    const FittedSet& leading() const;

    /// Whether something added is better than nothing.
    bool names() const { return &leading() != &result_.retuned; }

    /// Puts the best sets first; those that physics forbids go.
    void sort();

  private:
    /// The derivatives of all sets but the best, which other fits start from.
    void let_go();
    void try_relatives(std::size_t index, double share);
    void drop_where(const std::function<bool(const FittedSet&)>& is_dropped);
    void refuse_noise(std::size_t index, const Fit& near, double share);
    const Fit& most_probable() const;

    /// Whether a fit of these members is known that is more probable than where `near` would start another. A member
    /// that is needless leaves its set far above that.
    bool is_fitted_better(const Fit& near, const std::vector<Candidate>& members,
                          const std::vector<std::string>& released) const;

    const BelievedCase& believed_;
    const LikelihoodContext& context_;
    const NamingOptions& options_;
    NamingResult& result_;
    double pruned_ = 0.0;  ///< score of the set whose members were left out last
};

}  // namespace railpem::diagnosis
