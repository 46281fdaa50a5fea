#include "diagnosis/name.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>

#include "diagnosis/channel_delays.hpp"
#include "diagnosis/channel_resonances.hpp"
#include "diagnosis/comb_distances.hpp"
#include "diagnosis/effort.hpp"
#include "diagnosis/hold_out_recordings.hpp"
#include "diagnosis/model_error.hpp"
#include "diagnosis/set_trials.hpp"
#include "diagnosis/verdict.hpp"
#include "diagnosis/worth_refitting.hpp"

namespace railpem::diagnosis {

namespace {

constexpr double kBluntSearch = 0.1;   ///< relative floor
constexpr double kHalfSharpMiss = 0.05; ///< of what retuning misses, a single that is there may leave when half sharp: axles that bend left nothing, failed fasteners and friction of 1 kN in their own place 0.6 and 2.6 %, fasteners in the place of ballast and of two other effects 7 and 11 %
constexpr double kOutdone = 0.1;       ///< of what an unknown explains bluntly: the best names had 1 % of a linkage of the bogies, a single of the two effects of the paper 48 %
constexpr double kMinor = 0.05;        ///< share of what a single explains: for what is left of that order nothing else is sought in its place. Two may stand in for one (pads that stiffen and a mass on the rail for ballast)
// Shares of the effort, from which on no search begins that would not end: further climbs from afar and pairs with the blunt likelihood, starts from afar beside a single, the search from afar with the sharp likelihood, third members.
constexpr double kBluntFromAfar = 0.65, kBluntPairs = 0.75, kBesideSingle = 0.45, kSharpFromAfar = 0.7, kThirdMember = 0.8;
constexpr std::size_t kSharpened = 3;  ///< of the effects fitted from afar: those that the blunt likelihood prefers, until nothing is left

class Search {
  public:
    Search(const BelievedCase& believed, const LikelihoodContext& context, const NamingOptions& options, NamingResult& result, bool& ended_early)
        : believed_(believed), context_(context), options_(options), result_(result), trials_(believed, context, options, result),
          allowed_s_(effort_allowed(*context.observations, options.effort_s)), ended_early_(ended_early) {}

    void run() {
        try {
            search();
        } catch (const Interrupted&) {
            result_.interrupted = true;
        }
        trials_.sort();
    }

  private:
    void search() {
        say("retuning", 0.0);
        trials_.retune();
        CandidateList list = candidates(believed_, result_.retuned.fit.trial, *context_.observations);
        result_.not_tested = list.not_tested;
        for (const std::string& effect : options_.without) result_.not_tested.push_back({effect, "it was to be left out of the catalogue"});
        result_.candidates = std::move(list.candidates);
        if (misses_much(result_.retuned.fit, context_)) {
            blunt_search();
            if (outdone_) return;
            if (trials_.names() && !is_doubtful(trials_.leading()) && leaves_little()) return;
        }
        if (result_.sets.empty()) {
            result_.first_promises = screened(result_.retuned.fit);
            first_round();
        }
        further_rounds(2);
        if (!is_doubtful(trials_.leading()) && !is_trifling(trials_.leading())) {
            if (leaves_little()) return;
            if (trials_.leading().members() == 1 && left_over() < kMinor * (trials_.leading().score() - result_.retuned.score())) return;
        }
        if (is_spent(kSharpFromAfar)) return static_cast<void>(left_over());
        const double before = trials_.leading().score();
        rescue_round();
        if (trials_.leading().score() > before + options_.least_gain) further_rounds(2);
        if (const FittedSet* single = trials_.best(1); !is_spent(kSharpFromAfar) && is_doubtful(trials_.leading()) && single != nullptr && !single->effects.empty()) {
            rescue_round(single);
            further_rounds(3);
        }
        left_over();
    }

    /// Larger sets from the best of `from` − 1 members on. One grown member by member may hold some that a later one has made needless: without those it
    /// grows again.
    void further_rounds(int from) {
        for (int members = from; members <= options_.most_effects; ++members)
            if (is_spent(members > 2 ? kThirdMember : 1.0) || !further_round(members)) break;
        if (const std::size_t left = trials_.prune(); left > 0) further_rounds(static_cast<int>(left) + 1);
    }

    void grow_leading() { further_rounds(static_cast<int>(trials_.leading().members()) + 1); }

    /// The search for one or two effects with a blunt likelihood, in which the retuned case stays near what was believed. The best single is sharpened first: where it leaves little,
    /// the search goes on from it, and nothing else need be asked of the blunt. Otherwise from the best set, sharpened.
    void blunt_search() {
        result_.retuned.fit.derivatives.reset();  // nothing starts from there
        const LikelihoodContext blunt = blunted(context_, kBluntSearch);
        NamingResult found;
        NamingOptions pairs = options_;
        pairs.most_effects = std::min(2, options_.most_effects);
        Search search(believed_, blunt, pairs, found, ended_early_);
        search.trials_.retune();
        found.candidates = candidates(believed_, found.retuned.fit.trial, *blunt.observations).candidates;
        found.first_promises = search.screened(found.retuned.fit);
        search.first_round();
        const double single = search.trials_.leading().score();
        FittedSet put_off;  // of an approximate law that leaves more than is usual: something else may take its place
        if (single > found.retuned.score() + options_.least_gain) {
            Halved half = look_sharper(search.trials_.leading(), found.retuned.fit);
            if (!half.sharpened && is_approximate(half.set)) put_off = std::move(half.set);
            if (trials_.names() && leaves_little()) return grow_leading();
        }
        if (search.misses()) search.rescue_round();  // before anything is added to what stands in for it
        if (!is_spent(kBluntPairs)) search.further_rounds(2);
        blunt_from_afar_ = std::move(search.blunt_from_afar_);
        const double least = std::max(single, found.retuned.score()) + options_.least_gain;
        Halved seen;  // before more is looked for: what is there leaves misfit, too, as long as it is fitted bluntly (both effects of the paper, seed 9601)
        if (search.misses() && search.trials_.leading().score() > least) {
            seen = look_sharper(search.trials_.leading(), found.retuned.fit);
            if (trials_.names() && leaves_little()) return grow_leading();
        }
        outdone_ = search.misses() && search.is_outdone();
        result_.blunt_corrections = std::move(found.blunt_corrections);
        if (outdone_) return;
        if (!is_spent(kBesideSingle)) search.rescue_beside();
        const FittedSet& best = search.trials_.leading();
        if (best.score() <= least) {
            if (!put_off.effects.empty()) sharpen(put_off);
        } else if (!has_members(best, seen.set.effects, seen.set.released)) {
            sharpen(half_sharp(best));
        } else if (!seen.sharpened) {
            sharpen(seen.set);
        }
        if (!result_.sets.empty()) grow_leading();
    }

    /// Whether an unknown of one place explains so much more than the best names, bluntly, that no search will end with a name. Sensors do not count, as in is_evident_among().
    bool is_outdone() {
        result_.blunt_corrections = blunt_corrections(believed_, context_, [this](const std::string& what) { say(what, 0.5); });
        const double nothing = result_.retuned.score();
        double most = 0.0;
        for (const FittedSet& own : result_.blunt_corrections.sets)
            if (own.anonymous.front().element != Element::sensor) most = std::max(most, own.score() - nothing);
        return trials_.leading().score() - nothing < kOutdone * most;
    }

    /// A set of the blunt search, half sharp; sharpened at once where that leaves next to nothing of what retuning misses.
    struct Halved {
        FittedSet set;
        bool sharpened = false;
    };
    Halved look_sharper(const FittedSet& blunt, const Fit& retuned) {
        Halved own{half_sharp(blunt)};
        own.sharpened = is_worth_sharpening(own.set, retuned);
        if (own.sharpened) sharpen(own.set);
        return own;
    }

    FittedSet half_sharp(const FittedSet& blunt) const {
        return half_sharpened(believed_, blunt, context_, [this] { say("sharpening", 0.5); });
    }

    void sharpen(const FittedSet& half) {
        result_.sets.push_back(sharpened(believed_, half, context_, [this] { say("sharpening", 0.5); }));
    }

    /// Half sharp, what is there leaves next to nothing of what retuning misses.
    bool is_worth_sharpening(const FittedSet& half, const Fit& retuned) const {
        const LikelihoodContext half_sharp = blunted(context_, kHalfSharpFloor);
        return missed_by(half.fit, half_sharp) < kHalfSharpMiss * missed_by(retuned, half_sharp);
    }

    std::vector<Promise> screened(const Fit& fit) {
        say("screening the catalogue", 0.65);
        add_combs(fit, context_, result_.candidates);
        add_delays(fit, context_, result_.candidates);
        add_resonances(fit, context_, result_.candidates);
        std::erase_if(result_.candidates, [&](const Candidate& own) { return is_left_out(own.instance.effect); });
        return screen(fit, result_.candidates, context_);
    }

    bool is_left_out(const std::string& effect) const {
        return std::find(options_.without.begin(), options_.without.end(), effect) != options_.without.end();
    }

    /// Numbers whose belief is worth giving up.
    std::vector<std::string> releasable(const Fit& fit, const std::vector<std::string>& released, int most) const {
        return is_left_out("parameter-error") ? std::vector<std::string>{} : worth_releasing(fit, released, kLeastRelease, most);
    }

    /// Whether the unseen part shows again what the best set leaves.
    bool misses() {
        return missed_by(trials_.leading().fit, context_) > options_.residual;
    }

    /// Nats that may be left beside the best set.
    double bearable() const {
        return trials_.names() ? nats_left(trials_.leading(), result_.retuned.score(), options_.residual) : options_.residual;
    }

    /// Nats that a free correction would still bring beside the best set.
    double left_over() {
        if (trials_.leading().score() == left_beside_) return most_left_;
        say("what is left", 0.7);
        std::vector<LocatedEvidence> left = locate(trials_.leading().fit, context_);
        left_beside_ = trials_.leading().score();
        most_left_ = left.empty() ? 0.0 : left.front().nats;
        (trials_.names() ? result_.left_by_best : result_.left_by_retuned) = std::move(left);
        return most_left_;
    }

    /// Whether nothing worth a further search is left beside the best set. What the unseen part repeats of its misfit is seen at once; free corrections
    /// are asked only where that is little.
    bool leaves_little() {
        const FittedSet& best = trials_.leading();
        const double misfit = trials_.names() ? misfit_left(best, result_.retuned.score(), options_.residual) : options_.residual;
        return missed_by(best.fit, context_) <= misfit && left_over() < bearable();
    }

    /// A strong effect distorts the retuned case so much that no first derivative finds it from there, and as little `beside` a set while it is not among its members. Effects of the evident
    /// places, and those that follow the load, are fitted at a typical strength with a blunt likelihood first, from where that retunes the case without them.
    void rescue_round(const FittedSet* beside = nullptr) {
        const std::vector<Candidate> members = beside ? beside->effects : std::vector<Candidate>{};
        if (result_.left_by_retuned.empty()) result_.left_by_retuned = locate(result_.retuned.fit, context_);
        const auto is_evident = [&](Element element) {
            if (element == Element::support) element = Element::pad;  // rigid ground has no correction of its own
            return is_evident_among(result_.left_by_retuned, element, options_.residual) || is_evident_among(result_.left_by_best, element, options_.residual);
        };
        std::vector<FittedSet> blunt = fitted_from_afar(beside, members, variants_from_afar(result_.candidates, members, is_evident));
        if (trials_.is_blunt()) {
            if (!beside) blunt_from_afar_ = blunt;
            return static_cast<void>(std::move(blunt.begin(), blunt.end(), std::back_inserter(result_.sets)));
        }
        std::stable_sort(blunt.begin(), blunt.end(), [](const FittedSet& a, const FittedSet& b) { return a.fit.log_posterior > b.fit.log_posterior; });
        const FittedSet* best = trials_.best(members.size() + 1);
        const bool contested = best && std::isfinite(best->score());
        const Fit rival = contested ? best->fit : Fit{};  // sets may move
        for (std::size_t i = 0; i < std::min(kSharpened, blunt.size()); ++i) {
            const auto step = [&] { say(label_of(blunt[i].effects.back().instance) + " from afar", 0.7); };
            result_.sets.push_back(sharpened(believed_, half_sharpened(believed_, blunt[i], context_, step), context_, step, contested ? &rival : nullptr));
            if (leaves_little() || is_spent()) break;
        }
    }

    /// The blunt fits of a rescue round; alone, what the blunt search has fitted from afar already is not fitted again.
    std::vector<FittedSet> fitted_from_afar(const FittedSet* beside, const std::vector<Candidate>& members, std::vector<std::vector<Candidate>> variants) const {
        const auto between = [this](const Candidate& own) { say(label_of(own.instance) + " from afar", 0.7); };
        std::vector<FittedSet> known;
        if (!beside) known = blunt_from_afar_;
        std::erase_if(variants, [&](const std::vector<Candidate>& own) {
            return std::any_of(known.begin(), known.end(), [&](const FittedSet& set) { return same_variant(set.effects.back().instance, own.front().instance); });
        });
        // Of another floor and other windows neither values nor derivatives are a start.
        const Fit believed;
        const Fit& near = !trials_.is_blunt() ? believed : beside ? beside->fit : result_.retuned.fit;
        std::vector<FittedSet> blunt = blunt_from_afar(believed_, near, members, variants, context_, between, [this] { return is_spent(trials_.is_blunt() ? kBluntFromAfar : 1.0); });
        std::move(known.begin(), known.end(), std::back_inserter(blunt));
        return blunt;
    }

    /// The best single leaves much, and no derivative beside it leads to what explains that: the second of two strong effects.
    void rescue_beside() {
        const FittedSet* single = trials_.best(1);
        if (!misses() || single == nullptr || single->effects.empty()) return;
        left_over();
        rescue_round(single);
    }

    void first_round() {
        std::vector<Starts> chosen = worth_refitting(result_.first_promises, result_.candidates, options_.least_promise, options_.refits);
        const std::vector<std::string> keys = releasable(result_.retuned.fit, {}, 2);
        add_replacing(result_.first_promises, result_.candidates, keys, chosen);
        const double step = 0.4 / static_cast<double>(chosen.size() + keys.size() + 1);
        double share = 0.25;
        for (const Starts& starts : chosen) trials_.try_starts(result_.retuned.fit, starts, {}, {}, share += step);
        for (const std::string& key : keys) trials_.try_set(result_.retuned.fit, {}, {key}, share += step);
    }

    /// Adds a member to the best smaller set, then swaps the others. False when nothing was gained.
    bool further_round(int members) {
        trials_.finish_best(static_cast<std::size_t>(members - 1));
        const FittedSet* base = trials_.best(static_cast<std::size_t>(members - 1));
        const FittedSet* before = trials_.best(static_cast<std::size_t>(members - 2));
        const double smaller = before ? before->score() : result_.retuned.score();
        if (!base || base->score() < smaller + options_.least_gain) return false;
        if (extended_[members] == base->score()) return false;  // tried already, to no avail
        extended_[members] = base->score();
        FittedSet from = *base;
        restore_caches(from.fit, context_);
        const double share = 0.65 + 0.1 * (members - 2);
        const std::vector<Promise> promises = screened(from.fit);
        // Beside a law that is an approximation the rest of its own imitates much.
        const double least = is_approximate(from) ? nats_left(from, result_.retuned.score(), options_.least_promise) : options_.least_promise;
        std::vector<Starts> chosen = worth_refitting(promises, result_.candidates, least, options_.later_refits + 2);
        const auto is_member = [&](const Starts& starts) {  // as often as it may be
            const EffectInstance& instance = result_.candidates[starts.front().candidate].instance;
            return std::count_if(from.effects.begin(), from.effects.end(), [&](const Candidate& own) { return same_variant(own.instance, instance); }) >=
                   find_effect(instance.effect)->most_instances;
        };
        std::erase_if(chosen, is_member);
        if (static_cast<int>(chosen.size()) > options_.later_refits) chosen.erase(chosen.begin() + options_.later_refits, chosen.end());
        // What replaces a law sits where free corrections see it: where they find nothing, its promise is the shadow of the step that replaces.
        const auto replaces = [&](const Starts& starts) { return find_effect(result_.candidates[starts.front().candidate].instance.effect)->replaces; };
        if (trials_.is_blunt() || leaves_little()) std::erase_if(chosen, replaces);
        else add_unpromised(promises, result_.candidates, chosen);
        std::erase_if(chosen, is_member);
        Candidate winner;
        double highest = -1e300;
        for (const Starts& starts : chosen) {
            if (is_spent()) break;
            const FittedSet& tried = trials_.try_starts(from.fit, starts, from.effects, from.released, share);
            if (tried.score() > highest) highest = tried.score(), winner = tried.effects.back();
        }
        for (const std::string& key : releasable(from.fit, from.released, 1)) {
            std::vector<std::string> released = from.released;
            released.push_back(key);
            trials_.try_set(from.fit, from.effects, released, share);
        }
        if (members == 2 && highest > from.score() + options_.least_gain) trials_.swap_first(winner, from, share);
        const FittedSet* larger = trials_.best(static_cast<std::size_t>(members));
        return larger && larger->score() > from.score() + options_.least_gain;
    }

    /// Whether a share of the effort allowed is spent; what asks for it leaves out what it would have looked for.
    bool is_spent(double share = 1.0) const {
        const bool spent = context_.effort->seconds() > share * allowed_s_;
        ended_early_ = ended_early_ || spent;
        return spent;
    }

    void say(const std::string& what, double share) const { trials_.say(what, share); }

    const BelievedCase& believed_;
    const LikelihoodContext& context_;
    const NamingOptions& options_;
    NamingResult& result_;
    SetTrials trials_;
    double allowed_s_;    ///< effort
    bool& ended_early_;   ///< of the whole search: something was left out for it
    bool outdone_ = false;                    ///< by an unknown of one place: is_outdone()
    std::vector<FittedSet> blunt_from_afar_;  ///< singles that the blunt search has fitted from afar
    std::map<int, double> extended_;  ///< score of the set to which a further member was sought last, by the number of members
    double left_beside_ = -std::numeric_limits<double>::infinity(), most_left_ = 0.0;  ///< score of the set that left_over() looked at last, and its answer
};

}  // namespace

NamingResult name_physics(const BelievedCase& believed, const LikelihoodContext& context, const NamingOptions& options) {
    NamingResult result;
    result.unseen_share = unseen_share(*context.observations);
    Effort own;
    LikelihoodContext counted = context;
    if (!counted.effort) counted.effort = &own;
    bool ended_early = false;
    Search(believed, counted, options, result, ended_early).run();
    if (ended_early) result.not_tested.push_back({"further sets of effects", fmt::format("the search ended at the effort that it is allowed ({:.0f} s of one core as it counts; --effort)", counted.effort->seconds())});
    return result;
}

}  // namespace railpem::diagnosis
