#include "diagnosis/name.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>

#include "diagnosis/best_start.hpp"
#include "diagnosis/comb_distances.hpp"
#include "diagnosis/comb_relatives.hpp"
#include "diagnosis/from_afar.hpp"
#include "diagnosis/model_error.hpp"
#include "diagnosis/repeated_misfit.hpp"
#include "diagnosis/worth_refitting.hpp"

namespace railpem::diagnosis {

namespace {

constexpr double kLeastRelease = 3.0;  ///< nats to first order; what a wrong belief distorts is seen too small from there

/// Thrown between steps when somebody wants to end the search.
struct Interrupted {};

constexpr double kDistorted = 4.0;     ///< tolerances that a number may end away from what was believed
constexpr double kMuchMisfit_per_s = 100.0;  ///< nats that retuning may leave for its derivatives to be trusted
constexpr double kBluntSearch = 0.1;   ///< relative floor
constexpr int kBluntRetuning = 8;
constexpr double kMinor = 0.05;        ///< share of what a set explains: for what is left of that order no other set is sought in its place
constexpr double kFar = 50.0;          ///< nats that a start may lie below the fit that it starts from and still be near
constexpr int kFarIterations = 4;
constexpr int kContinuations = 3;
constexpr std::size_t kSharpened = 3;  ///< of the effects fitted from afar: those that the blunt likelihood prefers, until nothing is left

/// Whether an effect comes in many numbered variants (orders of a wheel, every n-th seat): those are told by their lines, which the first
/// derivative sees wherever the fit stands.
bool is_numbered(const Effect& effect) {
    return std::any_of(effect.choices.begin(), effect.choices.end(), [](const EffectChoice& choice) { return choice.whole_number; });
}

class Search {
  public:
    Search(const BelievedCase& believed, const LikelihoodContext& context, const NamingOptions& options, NamingResult& result)
        : believed_(believed), context_(context), options_(options), result_(result) {}

    void run() {
        try {
            search();
        } catch (const Interrupted&) {
            result_.interrupted = true;
        }
        sort_sets();
    }

  private:
    void search() {
        say("retuning", 0.0);
        retune();
        say("screening the catalogue", 0.15);
        CandidateList list = candidates(believed_, result_.retuned.fit.trial, *context_.observations);
        result_.not_tested = list.not_tested;
        result_.candidates = std::move(list.candidates);
        result_.first_promises = screened(result_.retuned.fit);
        if (is_distorted(result_.retuned.fit)) {
            blunt_search();
            if (left_over() < bearable()) return;
        }
        if (result_.sets.empty()) first_round();
        further_rounds(2);
        if (left_over() < bearable()) return;
        if (left_over() < kMinor * (best_score() - result_.retuned.score())) return;
        const double before = best_score();
        rescue_round();
        if (best_score() < before + options_.least_gain) return;
        further_rounds(2);
        left_over();
    }

    /// Larger sets from the best of `from` − 1 members on. One grown member by member may hold some that a later one has made needless: without those it
    /// grows again.
    void further_rounds(int from) {
        for (int members = from; members <= options_.most_effects; ++members)
            if (!further_round(members)) break;
        if (const std::size_t left = pruned(); left > 0) further_rounds(static_cast<int>(left) + 1);
    }

    /// The best set without each of its members in turn. The size of what is then the best set, where that is another; 0 otherwise.
    std::size_t pruned() {
        sort_sets();
        if (result_.sets.empty() || result_.sets.front().members() < 2 || result_.sets.front().score() == pruned_) return 0;
        const FittedSet& whole = result_.sets.front();
        pruned_ = whole.score();
        const Fit near{.trial = whole.fit.trial, .unknowns = whole.fit.unknowns, .values = whole.fit.values};
        const std::vector<Candidate> members = whole.effects;
        const std::vector<std::string> released = whole.released;
        for (std::size_t i = 0; i < members.size() + released.size(); ++i) {
            std::vector<Candidate> fewer = members;
            std::vector<std::string> numbers = released;
            if (i < members.size()) fewer.erase(fewer.begin() + static_cast<long>(i));
            else numbers.erase(numbers.begin() + static_cast<long>(i - members.size()));
            try_set(near, std::move(fewer), std::move(numbers), 0.72, true);
        }
        sort_sets();
        return result_.sets.front().members() < members.size() + released.size() ? result_.sets.front().members() : 0;
    }

    /// Retuning has bent the believed numbers so far, and to so little avail, that a derivative at the retuned case says nothing of the believed one.
    bool is_distorted(const Fit& retuned) const {
        const RepeatedMisfit left = repeated_misfit(retuned.trial, retuned.predictions, context_);
        if (left.nats < kMuchMisfit_per_s * left.seconds) return false;
        for (std::size_t u = 0; u < retuned.unknowns.size(); ++u)
            if (retuned.unknowns[u].kind == UnknownKind::number && std::abs(retuned.values[u]) > kDistorted * retuned.unknowns[u].deviation) return true;
        return false;
    }

    /// The search for one or two effects with a blunt likelihood, in which the retuned case stays near what was believed. The best
    /// set is then sharpened, and the search goes on from there.
    void blunt_search() {
        LikelihoodContext blunt = context_;
        blunt.least_floor = kBluntSearch;
        NamingResult found;
        NamingOptions pairs = options_;
        pairs.most_effects = std::min(2, options_.most_effects);
        Search search(believed_, blunt, pairs, found);
        search.retune();
        found.candidates = result_.candidates;
        found.first_promises = screen(found.retuned.fit, found.candidates, blunt);
        search.first_round();
        search.further_rounds(2);
        if (search.misses()) {
            search.rescue_round();
            search.further_rounds(2);
        }
        search.sort_sets();
        if (found.sets.empty() || found.sets.front().score() < found.retuned.score() + options_.least_gain) return;
        result_.sets.push_back(sharpened(believed_, found.sets.front(), context_, [this] { say("sharpening", 0.5); }));
        further_rounds(static_cast<int>(result_.sets.back().members()) + 1);
    }

    std::vector<Promise> screened(const Fit& fit) {
        add_combs(fit, context_, result_.candidates);
        return screen(fit, result_.candidates, context_);
    }

    /// Whether the unseen part shows again what the best set leaves.
    bool misses() {
        sort_sets();
        const bool named = !result_.sets.empty() && result_.sets.front().score() > result_.retuned.score();
        return missed_by(named ? result_.sets.front().fit : result_.retuned.fit, context_).nats > options_.residual;
    }

    double best_score() const {
        double score = result_.retuned.score();
        for (const FittedSet& set : result_.sets) score = std::max(score, set.score());
        return score;
    }

    /// Nats that may be left beside the best set, which left_over() put in front.
    double bearable() const {
        const bool named = !result_.sets.empty() && result_.sets.front().score() > result_.retuned.score();
        const double left = named ? nats_left(result_.sets.front(), result_.retuned.score(), options_.residual) : options_.residual;
        return left + room_beside(named ? result_.sets.front().fit.trial : result_.retuned.fit.trial, context_);
    }

    /// Nats that a free correction would still bring beside the best set.
    double left_over() {
        sort_sets();
        const bool named = !result_.sets.empty() && result_.sets.front().score() > result_.retuned.score();
        const double score = named ? result_.sets.front().score() : result_.retuned.score();
        if (score == left_beside_) return most_left_;
        say("what is left", 0.7);
        std::vector<LocatedEvidence> left = locate(named ? result_.sets.front().fit : result_.retuned.fit, context_);
        const double most = left.empty() ? 0.0 : left.front().nats;
        (named ? result_.left_by_best : result_.left_by_retuned) = std::move(left);
        left_beside_ = score;
        return most_left_ = most;
    }

    /// Is a place of the structure evident? Sensors do not count: free at every frequency, one imitates what its channel shows most.
    bool is_among(const std::vector<LocatedEvidence>& left, Element element) const {
        constexpr double kEvident = 0.1;  ///< share of the most evident place's nats
        double most = options_.residual / kEvident;
        for (const LocatedEvidence& own : left)
            if (own.place.element != Element::sensor) most = std::max(most, own.nats);
        return std::any_of(left.begin(), left.end(), [&](const LocatedEvidence& own) { return own.place.element == element && own.nats > kEvident * most; });
    }

    /// A strong effect distorts the retuned case so much that no first derivative finds it from there. Effects of the evident
    /// places are fitted as the retuned case was: from the believed numbers, at a typical strength, with a blunt likelihood first.
    void rescue_round() {
        if (result_.left_by_retuned.empty()) result_.left_by_retuned = locate(result_.retuned.fit, context_);
        const auto is_evident = [&](Element element) {
            if (element == Element::support) element = Element::pad;  // rigid ground has no correction of its own
            return is_among(result_.left_by_retuned, element) || is_among(result_.left_by_best, element);
        };
        std::vector<std::string> done;
        std::vector<FittedSet> blunt;
        for (const Candidate& candidate : result_.candidates) {
            const Effect& effect = *find_effect(candidate.instance.effect);
            const Element element = element_of(effect, candidate.instance);
            if (element == Element::sensor || element == Element::irregularity || element == Element::contact || is_numbered(effect)) continue;
            const std::string label = label_of(candidate.instance);
            if (!is_evident(element) || std::find(done.begin(), done.end(), label) != done.end()) continue;
            done.push_back(label);
            blunt.push_back(blunt_from_afar(believed_, candidate, context_, [this, label] { say(label + " from afar", 0.7); }));
        }
        if (is_blunt()) return static_cast<void>(std::move(blunt.begin(), blunt.end(), std::back_inserter(result_.sets)));
        std::stable_sort(blunt.begin(), blunt.end(), [](const FittedSet& a, const FittedSet& b) { return a.fit.log_posterior > b.fit.log_posterior; });
        for (std::size_t i = 0; i < std::min(kSharpened, blunt.size()); ++i) {
            const std::string label = label_of(blunt[i].effects.front().instance);
            result_.sets.push_back(sharpened(believed_, blunt[i], context_, [this, label] { say(label + " from afar", 0.7); }));
            if (left_over() < bearable()) break;
        }
    }

    bool is_blunt() const { return context_.least_floor > 0.0; }

    void say(const std::string& what, double share) {
        if (options_.progress) options_.progress(what, share);
        if (options_.interrupted && options_.interrupted()) throw Interrupted{};
    }

    const Fit& most_probable() const {
        const Fit* found = &result_.retuned.fit;
        for (const FittedSet& set : result_.sets)
            if (set.fit.log_posterior > found->log_posterior) found = &set.fit;
        return *found;
    }

    void retune() {
        const Trial trial = believed_trial(believed_, *context_.observations);
        std::vector<Unknown> unknowns = nuisance_unknowns(believed_, *context_.observations);
        const std::vector<double> start = means(unknowns);
        FitOptions fit_options;
        fit_options.between = [this] { say("retuning", 0.05); };
        fit_options.from_far = !is_blunt();
        if (is_blunt()) fit_options.iterations = kBluntRetuning;
        result_.retuned.fit = fit(trial, std::move(unknowns), start, context_, fit_options);
        result_.retuned.held_out = part_log_likelihood(result_.retuned.fit, context_, Part::held_out);
    }

    const FittedSet& try_set(const Fit& near, std::vector<Candidate> members, std::vector<std::string> released, double share, bool far = false) {
        std::string text;
        for (const Candidate& member : members) text += (text.empty() ? "" : " + ") + label_of(member.instance);
        for (const std::string& key : released) text += (text.empty() ? "" : " + ") + key;
        say(text, share);
        FitOptions fit_options;
        fit_options.between = [this, text, share] { say(text, share); };
        fit_options.from_far = far && !is_blunt();
        if (far) fit_options.stage_iterations = kFarIterations;
        fit_options.rival = &most_probable();
        FittedSet fitted = fit_set(believed_, near, std::move(members), std::move(released), {}, context_, fit_options);
        result_.sets.push_back(std::move(fitted));
        return result_.sets.back();
    }

    /// Fits the best start of a variant.
    const FittedSet& try_starts(const Fit& near, const Starts& starts, std::vector<Candidate> members, std::vector<std::string> released, double share) {
        Started best = best_start(believed_, near, starts, result_.candidates, members, released, context_);
        members.push_back(best.candidate);
        // What replaces a law of the case begins far below it, however mild: it gets the way of the retuned case, blunt first.
        const bool far = best.log_posterior < near.log_posterior - kFar;
        try_set(best.near, std::move(members), std::move(released), share, far);
        return try_relatives(result_.sets.size() - 1, share);
    }

    /// A comb of lines is fitted again from the best of the distances that share lines with it. The better of both.
    const FittedSet& try_relatives(std::size_t index, double share) {
        const FittedSet& fitted = result_.sets[index];
        const std::vector<Candidate> members = fitted.effects;
        const std::vector<std::string> released = fitted.released;
        Fit best;
        double highest = fitted.fit.log_posterior - kFar;
        for (const EffectInstance& relative : comb_relatives(fitted.fit.trial.effects.back(), longest_comb_m(*context_.observations))) {
            Fit near{.trial = fitted.fit.trial, .unknowns = fitted.fit.unknowns, .values = fitted.fit.values};
            move_last(near, relative);
            const Supposition supposition = suppose(believed_, near, members, released, {}, context_);
            if (const double own = log_posterior_at(supposition.trial, supposition.unknowns, supposition.start, context_); own > highest) highest = own, best = std::move(near);
        }
        if (best.unknowns.empty()) return fitted;
        const FittedSet& other = try_set(best, members, released, share);
        return other.score() > result_.sets[index].score() ? other : result_.sets[index];
    }

    /// Gives the last effect of a fit other values.
    static void move_last(Fit& fit, const EffectInstance& values) {
        const Effect& effect = *find_effect(values.effect);
        const int last = static_cast<int>(fit.trial.effects.size()) - 1;
        for (std::size_t u = 0; u < fit.unknowns.size(); ++u) {
            if (fit.unknowns[u].kind != UnknownKind::effect || fit.unknowns[u].index != last) continue;
            for (const EffectParameter& parameter : effect.parameters)
                if (fit.unknowns[u].name == effect.id + "." + parameter.name) fit.values[u] = to_coordinate(parameter, values.values.at(parameter.name));
        }
    }

    void first_round() {
        std::vector<Starts> chosen = worth_refitting(result_.first_promises, result_.candidates, options_.least_promise, options_.refits);
        add_replacing(result_.first_promises, result_.candidates, chosen);
        const std::vector<std::string> keys = worth_releasing(result_.retuned.fit, {}, kLeastRelease, 2);
        const double step = 0.4 / static_cast<double>(chosen.size() + keys.size() + 1);
        double share = 0.25;
        for (const Starts& starts : chosen) try_starts(result_.retuned.fit, starts, {}, {}, share += step);
        for (const std::string& key : keys) try_set(result_.retuned.fit, {}, {key}, share += step);
    }

    const FittedSet* best(std::size_t members) const {
        const FittedSet* found = nullptr;
        for (const FittedSet& set : result_.sets)
            if (set.members() == members && (!found || set.score() > found->score())) found = &set;
        return found;
    }

    /// A fit that ran out of steps goes on: what it has left to gain would be put down to the next member.
    void finish_best(std::size_t members) {
        for (int i = 0; i < kContinuations; ++i) {
            const FittedSet* found = best(members);
            if (!found || found->fit.converged || found->score() < result_.retuned.score()) return;
            FittedSet& own = result_.sets[static_cast<std::size_t>(found - result_.sets.data())];
            const double before = own.score();
            FitOptions near{.from_far = false};
            near.between = [this] { say("going on", 0.6); };
            FittedSet further = fit_set(believed_, own.fit, own.effects, own.released, {}, context_, near);
            if (further.score() > before) own = std::move(further);
            if (own.score() < before + options_.least_gain) return;
        }
    }

    /// Adds a member to the best smaller set, then swaps the others. False when nothing was gained.
    bool further_round(int members) {
        finish_best(static_cast<std::size_t>(members - 1));
        const FittedSet* base = best(static_cast<std::size_t>(members - 1));
        const FittedSet* before = best(static_cast<std::size_t>(members - 2));
        const double smaller = before ? before->score() : result_.retuned.score();
        if (!base || base->score() < smaller + options_.least_gain) return false;
        if (extended_[members] == base->score()) return false;  // tried already, to no avail
        extended_[members] = base->score();
        const FittedSet from = *base;
        const double share = 0.65 + 0.1 * (members - 2);
        const std::vector<Promise> promises = screened(from.fit);
        // Beside a linearised law the rest of its own imitates much.
        const bool linearised = share_left(from) > share_left(result_.retuned);
        const double least = linearised ? nats_left(from, result_.retuned.score(), options_.least_promise) : options_.least_promise;
        std::vector<Starts> chosen = worth_refitting(promises, result_.candidates, least, options_.later_refits + 2);
        const auto is_member = [&](const Starts& starts) {
            return std::any_of(from.effects.begin(), from.effects.end(),
                               [&](const Candidate& own) { return same_variant(own.instance, result_.candidates[starts.front().candidate].instance); });
        };
        std::erase_if(chosen, is_member);
        std::erase_if(chosen, [&](const Starts& starts) {
            Trial with = from.fit.trial;
            with.effects.push_back(result_.candidates[starts.front().candidate].instance);
            return mistakes_sleepers(with);
        });
        if (static_cast<int>(chosen.size()) > options_.later_refits) chosen.erase(chosen.begin() + options_.later_refits, chosen.end());
        // What replaces a law sits where free corrections see it: where they find nothing, its promise is the shadow of the step that replaces.
        const auto replaces = [&](const Starts& starts) { return find_effect(result_.candidates[starts.front().candidate].instance.effect)->replaces; };
        if (is_blunt() || left_over() < bearable()) std::erase_if(chosen, replaces);
        else add_unpromised(promises, result_.candidates, chosen);
        std::erase_if(chosen, is_member);
        Candidate winner;
        double highest = -1e300;
        for (const Starts& starts : chosen) {
            const FittedSet& tried = try_starts(from.fit, starts, from.effects, from.released, share);
            if (tried.score() > highest) highest = tried.score(), winner = tried.effects.back();
        }
        for (const std::string& key : worth_releasing(from.fit, from.released, kLeastRelease, 1)) {
            std::vector<std::string> released = from.released;
            released.push_back(key);
            try_set(from.fit, from.effects, released, share);
        }
        if (members == 2 && highest > from.score() + options_.least_gain) swap_first(winner, from, share);
        const FittedSet* larger = best(static_cast<std::size_t>(members));
        return larger && larger->score() > from.score() + options_.least_gain;
    }

    /// The second member stays, the first is replaced by the other promising singles.
    void swap_first(const Candidate& second, const FittedSet& from, double share) {
        constexpr int kSwaps = 2;
        std::vector<const FittedSet*> singles;
        for (const FittedSet& set : result_.sets)
            if (set.effects.size() == 1 && set.released.empty() && !same_variant(set.effects[0].instance, second.instance) &&
                (from.effects.empty() || !same_variant(set.effects[0].instance, from.effects[0].instance)))
                singles.push_back(&set);
        std::sort(singles.begin(), singles.end(), [](const FittedSet* a, const FittedSet* b) { return a->score() > b->score(); });
        std::vector<Candidate> firsts;
        for (const FittedSet* single : singles)
            if (static_cast<int>(firsts.size()) < kSwaps && single->score() > result_.retuned.score()) firsts.push_back(single->effects[0]);
        for (const Candidate& first : firsts) try_set(result_.retuned.fit, {first, second}, {}, share);
    }

    void sort_sets() {
        std::erase_if(result_.sets, [](const FittedSet& set) { return mistakes_sleepers(set.fit.trial); });
        std::stable_sort(result_.sets.begin(), result_.sets.end(), [](const FittedSet& a, const FittedSet& b) { return a.score() > b.score(); });
    }

    const BelievedCase& believed_;
    const LikelihoodContext& context_;
    const NamingOptions& options_;
    NamingResult& result_;
    double pruned_ = 0.0;             ///< score of the set whose members were left out last
    std::map<int, double> extended_;  ///< score of the set to which a further member was sought last, by the number of members
    double left_beside_ = -std::numeric_limits<double>::infinity(), most_left_ = 0.0;  ///< score of the set that left_over() looked at last, and its answer
};

}  // namespace

NamingResult name_physics(const BelievedCase& believed, const LikelihoodContext& context, const NamingOptions& options) {
    NamingResult result;
    Search(believed, context, options, result).run();
    return result;
}

}  // namespace railpem::diagnosis
