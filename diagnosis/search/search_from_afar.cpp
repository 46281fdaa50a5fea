// What no derivative at the retuned case leads to: a search with a blunt likelihood, and effects from afar.

#include <algorithm>
#include <cmath>
#include <iterator>

#include "diagnosis/hypotheses/locate.hpp"
#include "diagnosis/judge/model_error.hpp"
#include "diagnosis/judge/verdict.hpp"
#include "diagnosis/search/from_afar.hpp"
#include "diagnosis/search/search.hpp"

namespace railpem::diagnosis {

namespace {

/// of what retuning misses, a single that is there may leave when half sharp: axles that bend left nothing, failed
/// fasteners and friction of 1 kN in their own place 0.6 and 2.6 %, fasteners in the place of ballast and of two other
/// effects 7 and 11 %
constexpr double kHalfSharpMiss = 0.05;
/// and its best set, without any hope: those that were right left nothing to 2.6 %, what stood in for a bump stop 70 %,
/// for ground that changes along the line more than retuning
constexpr double kHopelessMiss = 0.5;
/// of what the single in it leaves: no second member is there for that (98 % beside fasteners in the place of a play)
constexpr double kInVain = 0.9;
/// of what an unknown explains bluntly: the best names had 1 % of a linkage of the bogies, a single of the two effects
/// of the paper 48 %
constexpr double kOutdone = 0.1;
// Shares of the effort, from which on none of these begins that would not end: further climbs from afar and pairs with
// the blunt likelihood, starts from afar beside a single.
constexpr double kBluntFromAfar = 0.65, kBluntPairs = 0.75, kBesideSingle = 0.45;
constexpr std::size_t kGrownFrom = 3;  ///< singles
/// of the effects fitted from afar: those that the blunt likelihood prefers, until nothing is left
constexpr std::size_t kSharpened = 3;

}  // namespace

void Search::blunt_search() {
    result_.retuned.fit.derivatives.reset();  // nothing starts from there
    const LikelihoodContext blunt = blunted(context_, kFitSettings.ladder.front());
    NamingResult found;
    NamingOptions pairs = options_;
    pairs.most_effects = std::min(2, options_.most_effects);
    Search search(believed_, blunt, pairs, found, ended_early_);
    search.trials_.retune();
    found.candidates = candidates(believed_, found.retuned.fit.trial, *blunt.observations).candidates;
    found.first_promises = search.screened(found.retuned.fit);
    search.first_round();
    const double single = search.trials_.leading().score();
    Halved first, seen;
    if (single > found.retuned.score() + options_.least_gain) {
        first = look_sharper(search.trials_.leading(), {}, found.retuned.fit);
        if (trials_.names() && leaves_little()) return grow_leading();
    }
    if (search.misses()) search.rescue_round();  // before anything is added to what stands in for it
    if (!is_spent(kBluntPairs)) search.further_rounds(2);
    blunt_from_afar_ = std::move(search.blunt_from_afar_);
    const double least = std::max(single, found.retuned.score()) + options_.least_gain;
    // Before more is looked for: what is there leaves misfit, too, as long as it is fitted bluntly (both effects of the
    // paper, seed 9601).
    if (search.misses() && search.trials_.leading().score() > least) {
        seen = look_sharper(search.trials_.leading(), first, found.retuned.fit);
        if (trials_.names() && leaves_little()) return grow_leading();
    }
    outdone_ = search.misses() && search.is_outdone();
    result_.blunt_corrections = std::move(found.blunt_corrections);
    if (outdone_) return;
    if (!is_spent(kBesideSingle)) search.rescue_beside();
    if (const FittedSet& best = search.trials_.leading(); best.score() > least) {
        sharpen_grown(best, first, std::move(seen), found.retuned.fit);
    } else if (!first.sharpened && is_approximate(first.set)) {
        sharpen(first.set);  // it leaves more than is usual, and something else might have taken its place
    }
    if (!hopeless_ && !result_.sets.empty()) grow_leading();
}

void Search::sharpen_grown(const FittedSet& best, const Halved& first, Halved seen, const Fit& retuned) {
    if (!has_members(best, seen.set.effects, seen.set.released)) seen = half_sharp(best);
    const bool leaves_most = leaves(seen, kHopelessMiss, missed_by(retuned, blunted(context_, kHalfSharpFloor))),
               in_vain = is_in_vain(seen, first);
    hopeless_ = leaves_most || in_vain;
    if (hopeless_)
        result_.not_tested.push_back(
            {"further sets of effects", leaves_most ? "what was found leaves most of what retuning misses"
                                                    : "no second member explains what the best single leaves"});
    if (leaves_most) return;
    const Halved& own = in_vain ? first : seen;
    if (!own.sharpened) sharpen(own.set);
}

bool Search::is_outdone() {
    result_.blunt_corrections =
        blunt_corrections(believed_, context_, [this](const std::string& what) { say(what, 0.5); });
    const double nothing = result_.retuned.score();
    double most = 0.0;
    for (const FittedSet& own : result_.blunt_corrections.sets)
        if (own.anonymous.front().element != Element::sensor) most = std::max(most, own.score() - nothing);
    return trials_.leading().score() - nothing < kOutdone * most;
}

bool Search::leaves(const Halved& own, double share, double of) const {
    return own.missed > std::max(options_.residual, share * of);
}

bool Search::is_in_vain(const Halved& own, const Halved& first) const {
    return first.set.members() > 0 && extends(own.set, first.set) && leaves(own, kInVain, first.missed);
}

Search::Halved Search::look_sharper(const FittedSet& blunt, const Halved& first, const Fit& retuned) {
    Halved own = half_sharp(blunt);
    own.sharpened =
        own.missed < kHalfSharpMiss * missed_by(retuned, blunted(context_, kHalfSharpFloor)) && !is_in_vain(own, first);
    if (own.sharpened) sharpen(own.set);
    return own;
}

Search::Halved Search::half_sharp(const FittedSet& blunt) const {
    Halved own{.set = half_sharpened(believed_, blunt, context_, [this] { say("sharpening", 0.5); })};
    own.missed = missed_by(own.set.fit, blunted(context_, kHalfSharpFloor));
    own.set.fit.derivatives.reset();  // it goes on from the values alone
    return own;
}

void Search::sharpen(const FittedSet& half) {
    result_.sets.push_back(sharpened(believed_, half, context_, [this] { say("sharpening", 0.5); }));
}

void Search::rescue_round(const FittedSet* beside) {
    const std::vector<Candidate> members = beside ? beside->effects : std::vector<Candidate>{};
    if (result_.left_by_retuned.empty()) result_.left_by_retuned = locate(result_.retuned.fit, context_);
    const auto is_evident = [&](Element element) {
        if (element == Element::support) element = Element::pad;  // rigid ground has no correction of its own
        return is_evident_among(result_.left_by_retuned, element, options_.residual) ||
               is_evident_among(result_.left_by_best, element, options_.residual);
    };
    std::vector<FittedSet> blunt =
        fitted_from_afar(beside, members, variants_from_afar(result_.candidates, members, is_evident));
    if (trials_.is_blunt()) {
        if (!beside) blunt_from_afar_ = blunt;
        return static_cast<void>(std::move(blunt.begin(), blunt.end(), std::back_inserter(result_.sets)));
    }
    std::stable_sort(blunt.begin(), blunt.end(),
                     [](const FittedSet& a, const FittedSet& b) { return a.fit.log_posterior > b.fit.log_posterior; });
    const FittedSet* best = trials_.best(members.size() + 1);
    if (is_outdone_beyond_range() && (!best || best->fit.log_posterior < result_.beyond->fit.log_posterior))
        best = &*result_.beyond;
    const bool contested = best && std::isfinite(best->score());
    const Fit rival = contested ? best->fit : Fit{};  // sets may move
    for (std::size_t i = 0; i < std::min(kSharpened, blunt.size()); ++i) {
        const auto step = [&] { say(label_of(blunt[i].effects.back().instance) + " from afar", 0.7); };
        result_.sets.push_back(sharpened(believed_, half_sharpened(believed_, blunt[i], context_, step), context_, step,
                                         contested ? &rival : nullptr));
        if (leaves_little() || is_spent()) break;
    }
}

std::vector<FittedSet> Search::fitted_from_afar(const FittedSet* beside, const std::vector<Candidate>& members,
                                                std::vector<std::vector<Candidate>> variants) const {
    const auto between = [this](const Candidate& own) { say(label_of(own.instance) + " from afar", 0.7); };
    std::vector<FittedSet> known;
    if (!beside) known = blunt_from_afar_;
    std::erase_if(variants, [&](const std::vector<Candidate>& own) {
        // the data ask for more than it can be
        if (is_outdone_beyond_range() && same_variant(result_.beyond->effects.front().instance, own.front().instance))
            return true;
        return std::any_of(known.begin(), known.end(), [&](const FittedSet& set) {
            return same_variant(set.effects.back().instance, own.front().instance);
        });
    });
    // Of another floor and other windows neither values nor derivatives are a start.
    const Fit believed;
    const Fit& near = !trials_.is_blunt() ? believed : beside ? beside->fit : result_.retuned.fit;
    // Larger sets grow from the best single, and the two behind it take its place.
    const FittedSet* rival = trials_.is_blunt() && !beside ? trials_.single(kGrownFrom) : nullptr;
    std::vector<FittedSet> blunt = blunt_from_afar(
        believed_, near, members, variants, context_, between,
        [this] { return is_spent(trials_.is_blunt() ? kBluntFromAfar : 1.0); }, rival ? &rival->fit : nullptr);
    std::move(known.begin(), known.end(), std::back_inserter(blunt));
    return blunt;
}

void Search::rescue_beside() {
    const FittedSet* single = trials_.best(1);
    if (!misses() || single == nullptr || single->effects.empty()) return;
    left_over();
    rescue_round(single);
}

}  // namespace railpem::diagnosis
