#pragma once
// One search for a set of effects, sharp or with a blunt likelihood: what is known of it so far, and what it does next.

#include <limits>
#include <map>
#include <string>
#include <vector>

#include "diagnosis/hypotheses/naming_result.hpp"
#include "diagnosis/model/effort.hpp"
#include "diagnosis/search/from_afar.hpp"
#include "diagnosis/search/naming_options.hpp"
#include "diagnosis/search/set_trials.hpp"

namespace railpem::diagnosis {

/// Fills `result`. Everything is said on the way to NamingOptions::progress, and ends with what is known when
/// interrupted. `context` counts its effort; `ended_early` becomes true where something was left out for it.
class Search {
  public:
    Search(const BelievedCase& believed, const LikelihoodContext& context, const NamingOptions& options,
           NamingResult& result, bool& ended_early)
        : believed_(believed),
          context_(context),
          options_(options),
          result_(result),
          trials_(believed, context, options, result),
          allowed_s_(effort_allowed(*context.observations, options.effort_s)),
          ended_early_(ended_early) {}

    void run();

  private:
    void search();

    /// Larger sets from the best of `from` − 1 members on. One grown member by member may hold some that a later one
    /// has made needless: without those it grows again.
    void further_rounds(int from);

    void grow_leading() { further_rounds(static_cast<int>(trials_.leading().members()) + 1); }

    /// The search for one or two effects with a blunt likelihood, in which the retuned case stays near what was
    /// believed. The best single is sharpened first: where it leaves little, the search goes on from it, and nothing
    /// else need be asked of the blunt. Otherwise from the best set, sharpened.
    void blunt_search();

    /// Whether an unknown of one place explains so much more than the best names, bluntly, that no search will end with
    /// a name. Sensors do not count, as in is_evident_among().
    bool is_outdone();

    /// Fits the best single beyond the range of its physics, where it leans on its end and has no such fit yet.
    void look_beyond_range();

    /// Whether that explains more than twice as much as all that could be named: a third member that has more than two
    /// together have would have come first.
    bool is_outdone_beyond_range() const;

    /// A set of the blunt search, half sharp, and what it misses there; sharpened at once where that is next to nothing
    /// of what retuning misses, unless it extends the `first` in vain.
    struct Halved {
        FittedSet set;
        double missed = 0.0;
        bool sharpened = false;
    };
    Halved look_sharper(const FittedSet& blunt, const Halved& first, const Fit& retuned);
    Halved half_sharp(const FittedSet& blunt) const;
    void sharpen(const FittedSet& half);
    /// misses more than chance, and than that share of something
    bool leaves(const Halved& own, double share, double of) const;
    /// its further member explains hardly anything of what the first leaves
    bool is_in_vain(const Halved& own, const Halved& first) const;

    /// Sharpens the best set of the blunt search, larger than what it saw `first`, or better; `seen`: what was half
    /// sharpened of it. Hopeless where that leaves most of what retuning misses (nothing is sharpened then), or nearly
    /// all of what the first leaves (which then is).
    void sharpen_grown(const FittedSet& best, const Halved& first, Halved seen, const Fit& retuned);

    std::vector<Promise> screened(const Fit& fit);
    bool is_left_out(const std::string& effect) const;

    /// Numbers whose belief is worth giving up.
    std::vector<std::string> releasable(const Fit& fit, const std::vector<std::string>& released, int most) const;

    /// Whether the unseen part shows again what the best set leaves.
    bool misses();

    /// Nats that may be left beside the best set.
    double bearable() const;

    /// Nats that a free correction would still bring beside the best set.
    double left_over();
    bool knows_what_is_left() const;

    /// Whether nothing worth a further search is left beside the best set. What the unseen part repeats of its misfit
    /// is seen at once; free corrections are asked only where that is little.
    bool leaves_little();

    /// A strong effect distorts the retuned case so much that no first derivative finds it from there, and as little
    /// `beside` a set while it is not among its members. Effects of the evident places, and those that follow the load,
    /// are fitted at a typical strength with a blunt likelihood first, from where that retunes the case without them.
    void rescue_round(const FittedSet* beside = nullptr);

    /// The blunt fits of a rescue round; alone, what the blunt search has fitted from afar already is not fitted again.
    std::vector<FittedSet> fitted_from_afar(const FittedSet* beside, const std::vector<Candidate>& members,
                                            std::vector<std::vector<Candidate>> variants) const;

    /// The best single leaves much, and no derivative beside it leads to what explains that: the second of two strong
    /// effects.
    void rescue_beside();
    void first_round();

    /// What may be a further member of a set: of `least` nats of promise, and whatever replaces a law, where free
    /// corrections see something.
    std::vector<Starts> worth_adding(const FittedSet& from, double least);

    /// Adds a member to the best smaller set, then swaps the others. False when nothing was gained.
    bool further_round(int members);

    /// Whether a share of the effort allowed is spent; what asks for it leaves out what it would have looked for.
    bool is_spent(double share = 1.0) const;

    void say(const std::string& what, double share) const { trials_.say(what, share); }

    const BelievedCase& believed_;
    const LikelihoodContext& context_;
    const NamingOptions& options_;
    NamingResult& result_;
    SetTrials trials_;
    double allowed_s_;                        ///< effort
    bool& ended_early_;                       ///< of the whole search: something was left out for it
    bool outdone_ = false;                    ///< by an unknown of one place: is_outdone()
    bool hopeless_ = false;                   ///< nothing more is looked for: sharpen_grown()
    std::vector<FittedSet> blunt_from_afar_;  ///< singles that the blunt search has fitted from afar
    /// score of the set to which a further member was sought last, by the number of members
    std::map<int, double> extended_;
    /// score of the set that left_over() looked at last, and its answer
    double left_beside_ = -std::numeric_limits<double>::infinity(), most_left_ = 0.0;
};

}  // namespace railpem::diagnosis
