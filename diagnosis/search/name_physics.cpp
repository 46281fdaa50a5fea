#include "diagnosis/search/name_physics.hpp"

#include <algorithm>
#include <cmath>

#include "diagnosis/hypotheses/proposers/channel_delays.hpp"
#include "diagnosis/hypotheses/proposers/channel_resonances.hpp"
#include "diagnosis/hypotheses/proposers/comb_distances.hpp"
#include "diagnosis/hypotheses/worth_refitting.hpp"
#include "diagnosis/judge/model_error.hpp"
#include "diagnosis/judge/verdict.hpp"
#include "diagnosis/likelihood/hold_out_recordings.hpp"
#include "diagnosis/search/search.hpp"

namespace railpem::diagnosis {

namespace {

/// of what a further member has to bring: one whose fit cannot come to that is given up before its end
constexpr double kSureOf = 0.5;
/// share of what a single explains: for what is left of that order nothing else is sought in its place. Two may stand
/// in for one (pads that stiffen and a mass on the rail for ballast)
constexpr double kMinor = 0.05;
// Shares of the effort, from which on none of these begins that would not end: the search from afar with the sharp
// likelihood, after a blunt one or as the first of its kind, second and third members.
constexpr double kSharpFromAfar = 0.7, kFirstFromAfar = 1.3, kSecondMember = 0.9, kThirdMember = 0.8;

}  // namespace

void Search::run() {
    try {
        search();
    } catch (const Interrupted&) {
        result_.interrupted = true;
    }
    if (trials_.leading().score() != left_beside_) result_.left_by_best.clear();  // it was of another set
    trials_.sort();
}

void Search::search() {
    say("retuning", 0.0);
    trials_.retune();
    CandidateList list = candidates(believed_, result_.retuned.fit.trial, *context_.observations);
    result_.not_tested = list.not_tested;
    for (const std::string& effect : options_.without)
        result_.not_tested.push_back({effect, "it was to be left out of the catalogue"});
    result_.candidates = std::move(list.candidates);
    if (misses_much(result_.retuned.fit, context_)) {
        blunt_search();
        if (outdone_ || hopeless_) return;
        if (trials_.names() && !is_doubtful(trials_.leading()) && leaves_little()) return;
    }
    bool rescued = false;
    if (result_.sets.empty()) {
        result_.first_promises = screened(result_.retuned.fit);
        first_round();
        rescued = misses() && !leaves_little();
        if (rescued) rescue_round();  // before anything is added to what stands in for it
    }
    further_rounds(2);
    // Where the blunt search has looked for nothing from afar, this is worth more: preloaded pads stood as failed
    // fasteners. How much more, by judgement.
    const double share = blunt_from_afar_.empty() ? kFirstFromAfar : kSharpFromAfar;
    if (!knows_what_is_left() && is_spent(share)) return;  // whatever is left
    if (!is_doubtful(trials_.leading()) && !is_trifling(trials_.leading())) {
        if (leaves_little()) return;
        if (trials_.leading().members() == 1 &&
            left_over() < kMinor * (trials_.leading().score() - result_.retuned.score()))
            return;
    }
    if (is_spent(share)) return;
    const double before = trials_.leading().score();
    if (!rescued) rescue_round();
    if (trials_.leading().score() > before + options_.least_gain) further_rounds(2);
    if (const FittedSet* single = trials_.best(1);
        !is_spent(kSharpFromAfar) && is_doubtful(trials_.leading()) && single != nullptr && !single->effects.empty()) {
        rescue_round(single);
        further_rounds(3);
    }
}

void Search::further_rounds(int from) {
    for (int members = from; members <= options_.most_effects; ++members) {
        if (is_spent(members > 2 ? kThirdMember : kSecondMember)) break;
        if (members > 2 && !leaves_little()) look_beyond_range();
        if (is_outdone_beyond_range() || !further_round(members)) break;
    }
    if (is_outdone_beyond_range()) return;  // it will not be named: nobody asks what each of its members brings
    if (const std::size_t left = trials_.prune(); left > 0) further_rounds(static_cast<int>(left) + 1);
}

void Search::look_beyond_range() {
    const FittedSet* single = trials_.best(1);
    if (result_.beyond || trials_.is_blunt() || !single || single->effects.empty() ||
        !leans(*single, result_.retuned.score()))
        return;
    say("the best single beyond its range", 0.7);
    FittedSet from = *single;
    restore_caches(from.fit, context_);
    result_.beyond = fit_beyond_range(believed_, from, context_, {});
}

bool Search::is_outdone_beyond_range() const {
    const double best = trials_.leading().score();
    return result_.beyond && result_.beyond->score() - best > best - result_.retuned.score();
}

std::vector<Promise> Search::screened(const Fit& fit) {
    say("screening the catalogue", 0.65);
    add_combs(fit, context_, result_.candidates);
    add_delays(fit, context_, result_.candidates);
    add_resonances(fit, context_, result_.candidates);
    std::erase_if(result_.candidates, [&](const Candidate& own) { return is_left_out(own.instance.effect); });
    return screen(fit, result_.candidates, context_);
}

bool Search::is_left_out(const std::string& effect) const {
    return std::find(options_.without.begin(), options_.without.end(), effect) != options_.without.end();
}

std::vector<std::string> Search::releasable(const Fit& fit, const std::vector<std::string>& released, int most) const {
    return is_left_out("parameter-error") ? std::vector<std::string>{}
                                          : worth_releasing(fit, released, kLeastRelease, most);
}

bool Search::misses() {
    return missed_by(trials_.leading().fit, context_) > options_.residual;
}

double Search::bearable() const {
    return trials_.names() ? nats_left(trials_.leading(), result_.retuned.score(), options_.residual)
                           : options_.residual;
}

bool Search::knows_what_is_left() const {
    return trials_.leading().score() == left_beside_;
}

double Search::left_over() {
    if (knows_what_is_left()) return most_left_;
    say("what is left", 0.7);
    std::vector<LocatedEvidence> left = locate(trials_.leading().fit, context_);
    left_beside_ = trials_.leading().score();
    most_left_ = left.empty() ? 0.0 : left.front().nats;
    (trials_.names() ? result_.left_by_best : result_.left_by_retuned) = std::move(left);
    return most_left_;
}

bool Search::leaves_little() {
    const FittedSet& best = trials_.leading();
    const double misfit =
        trials_.names() ? misfit_left(best, result_.retuned.score(), options_.residual) : options_.residual;
    return missed_by(best.fit, context_) <= misfit && left_over() < bearable();
}

void Search::first_round() {
    std::vector<Starts> chosen =
        worth_refitting(result_.first_promises, result_.candidates, options_.least_promise, options_.refits);
    const std::vector<std::string> keys = releasable(result_.retuned.fit, {}, 2);
    add_replacing(result_.first_promises, result_.candidates, keys, chosen);
    const double step = 0.4 / static_cast<double>(chosen.size() + keys.size() + 1);
    double share = 0.25;
    for (const Starts& starts : chosen) trials_.try_starts(result_.retuned.fit, starts, {}, {}, share += step);
    for (const std::string& key : keys) trials_.try_set(result_.retuned.fit, {}, {key}, share += step);
}

std::vector<Starts> Search::worth_adding(const FittedSet& from, double least) {
    const std::vector<Promise> promises = screened(from.fit);
    std::vector<Starts> chosen = worth_refitting(promises, result_.candidates, least, options_.later_refits + 2);
    const auto is_member = [&](const Starts& starts) {  // as often as it may be
        const EffectInstance& instance = result_.candidates[starts.front().candidate].instance;
        return std::count_if(from.effects.begin(), from.effects.end(), [&](const Candidate& own) {
                   return same_variant(own.instance, instance);
               }) >= find_effect(instance.effect)->most_instances;
    };
    std::erase_if(chosen, is_member);
    if (static_cast<int>(chosen.size()) > options_.later_refits)
        chosen.erase(chosen.begin() + options_.later_refits, chosen.end());
    // What replaces a law sits where free corrections see it: where they find nothing, its promise is the shadow of the
    // step that replaces.
    const auto replaces = [&](const Starts& starts) {
        return find_effect(result_.candidates[starts.front().candidate].instance.effect)->replaces;
    };
    if (trials_.is_blunt() || leaves_little())
        std::erase_if(chosen, replaces);
    else
        add_unpromised(promises, result_.candidates, chosen);
    std::erase_if(chosen, is_member);
    return chosen;
}

bool Search::further_round(int members) {
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
    // Beside a law that is an approximation the rest of its own imitates much: what brings no more than that is dropped
    // by drop_superfluous().
    const bool approximate = is_approximate(from);
    const double least =
        approximate ? nats_left(from, result_.retuned.score(), options_.least_promise) : options_.least_promise;
    const double worth = approximate && !trials_.is_blunt()
                             ? nats_left(from, result_.retuned.score(), options_.least_gain)
                             : options_.least_gain;
    const double ahead = worth > options_.least_gain ? kSureOf * worth : 0.0;
    Candidate winner;
    double highest = -1e300;
    for (const Starts& starts : worth_adding(from, least)) {
        if (is_spent()) break;
        const FittedSet& tried = trials_.try_starts(from.fit, starts, from.effects, from.released, share, ahead);
        if (tried.score() > highest) highest = tried.score(), winner = tried.effects.back();
    }
    for (const std::string& key : releasable(from.fit, from.released, 1)) {
        std::vector<std::string> released = from.released;
        released.push_back(key);
        trials_.try_set(from.fit, from.effects, released, share, false, ahead);
    }
    if (members == 2 && highest > from.score() + options_.least_gain)
        trials_.swap_first(winner, from, highest - from.score(), share);
    if (worth > options_.least_gain) trials_.drop_beside(from, worth);
    if (!trials_.is_blunt()) trials_.drop_needless();
    const FittedSet* larger = trials_.best(static_cast<std::size_t>(members));
    return larger && larger->score() > from.score() + options_.least_gain;
}

bool Search::is_spent(double share) const {
    const bool spent = context_.effort->seconds() > share * allowed_s_;
    ended_early_ = ended_early_ || spent;
    return spent;
}

NamingResult name_physics(const BelievedCase& believed, const LikelihoodContext& context,
                          const NamingOptions& options) {
    NamingResult result;
    result.unseen_share = unseen_share(*context.observations);
    Effort own;
    LikelihoodContext counted = context;
    if (!counted.effort) counted.effort = &own;
    bool ended_early = false;
    Search(believed, counted, options, result, ended_early).run();
    if (ended_early)
        result.not_tested.push_back(left_out_for_effort("further sets of effects", *counted.effort,
                                                        effort_allowed(*context.observations, options.effort_s)));
    return result;
}

}  // namespace railpem::diagnosis
