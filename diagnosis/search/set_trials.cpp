#include "diagnosis/search/set_trials.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "diagnosis/hypotheses/best_start.hpp"
#include "diagnosis/hypotheses/proposers/comb_relatives.hpp"
#include "diagnosis/judge/verdict.hpp"

namespace railpem::diagnosis {

namespace {

constexpr int kBluntRetuning = 8;
constexpr double kFar = 50.0;  ///< nats that a start may lie below the fit that it starts from and still be near
constexpr int kFarIterations = 4;
constexpr int kContinuations = 3;
constexpr std::size_t kSwaps = 2;
constexpr int kDecoyIterations = 6;
constexpr double kDecoyShare = 0.5;  ///< of what a comb gains, that lines in other places gain too

/// Gives the last effect of a fit other values.
void move_last(Fit& fit, const EffectInstance& values) {
    const Effect& effect = *find_effect(values.effect);
    const int last = static_cast<int>(fit.trial.effects.size()) - 1;
    for (std::size_t u = 0; u < fit.unknowns.size(); ++u) {
        if (fit.unknowns[u].kind != UnknownKind::effect || fit.unknowns[u].index != last) continue;
        for (const EffectParameter& parameter : effect.parameters)
            if (fit.unknowns[u].name == effect.id + "." + parameter.name)
                fit.values[u] = to_coordinate(parameter, values.values.at(parameter.name));
    }
}

std::string text_of(const std::vector<Candidate>& members, const std::vector<std::string>& released) {
    std::string text;
    for (const Candidate& member : members) text += (text.empty() ? "" : " + ") + label_of(member.instance);
    for (const std::string& key : released) text += (text.empty() ? "" : " + ") + key;
    return text;
}

/// What other fits start from, without predictions and covariance.
Fit values_of(const Fit& fit) {
    return {.trial = fit.trial, .unknowns = fit.unknowns, .values = fit.values, .derivatives = fit.derivatives};
}

}  // namespace

SetTrials::SetTrials(const BelievedCase& believed, const LikelihoodContext& context, const NamingOptions& options,
                     NamingResult& result)
    : believed_(believed), context_(context), options_(options), result_(result) {}

bool SetTrials::is_blunt() const {
    return context_.least_floor > 0.0;
}

void SetTrials::say(const std::string& what, double share) const {
    if (options_.progress) options_.progress(what, share);
    if (options_.interrupted && options_.interrupted()) throw Interrupted{};
}

void SetTrials::retune() {
    const Trial trial = believed_trial(believed_, *context_.observations);
    std::vector<Unknown> unknowns = nuisance_unknowns(believed_, *context_.observations);
    const std::vector<double> start = means(unknowns);
    FitOptions fit_options;
    fit_options.between = [this] { say("retuning", 0.05); };
    fit_options.from_far = !is_blunt();
    if (is_blunt())
        fit_options.iterations = kBluntRetuning;
    else
        fit_options.patience = kFitSettings.retuning_patience;
    result_.retuned.fit = fit(trial, std::move(unknowns), start, context_, fit_options);
    result_.retuned.held_out = part_log_likelihood(result_.retuned.fit, context_, Part::held_out);
}

const FittedSet& SetTrials::try_set(const Fit& near, std::vector<Candidate> members, std::vector<std::string> released,
                                    double share, bool far, double ahead) {
    const std::string text = text_of(members, released);
    say(text, share);
    FitOptions fit_options;
    fit_options.between = [this, text, share] { say(text, share); };
    fit_options.from_far = far && !is_blunt();
    if (far)
        fit_options.stage_iterations = kFarIterations;
    else
        fit_options.room = -ahead;
    fit_options.rival = &most_probable();
    FittedSet fitted = fit_set(believed_, near, std::move(members), std::move(released), {}, context_, fit_options);
    result_.sets.push_back(std::move(fitted));
    let_go();
    return result_.sets.back();
}

void SetTrials::let_go() {
    const FittedSet& kept = leading();
    for (FittedSet& set : result_.sets) {
        if (&set == &kept) continue;
        set.fit.derivatives.reset();
        if (&set != best(set.members())) set.fit.predictions.caches = {};
    }
}

const FittedSet& SetTrials::try_starts(const Fit& near, const Starts& starts, const std::vector<Candidate>& members,
                                       const std::vector<std::string>& released, double share, double ahead) {
    const std::size_t first = result_.sets.size();
    for (const Starts& own : climbed_apart(starts, result_.candidates)) {
        Started best = best_start(believed_, near, own, result_.candidates, members, released, context_);
        std::vector<Candidate> with = members;
        with.push_back(best.candidate);
        // What replaces a law of the case begins far below it, however mild: it gets the way of the retuned case, blunt
        // first.
        const bool far = best.log_posterior < near.log_posterior - kFar;
        const std::size_t here = result_.sets.size();
        try_set(best.near, std::move(with), released, share, far, ahead);
        try_relatives(here, share);
    }
    const auto better = [](const FittedSet& a, const FittedSet& b) { return a.score() < b.score(); };
    for (std::size_t i = first; i < result_.sets.size(); ++i) refuse_noise(i, near, share);
    return *std::max_element(result_.sets.begin() + static_cast<long>(first), result_.sets.end(), better);
}

void SetTrials::refuse_noise(std::size_t index, const Fit& near, double share) {
    const FittedSet& comb = result_.sets[index];
    const double gain = comb.fit.log_likelihood - near.log_likelihood;
    // Only where it would be believed: the best set of its size.
    if (gain < options_.least_gain || &comb != best(comb.members())) return;
    FitOptions fit_options{.iterations = kDecoyIterations, .from_far = false};
    fit_options.between = [this, share] { say("a decoy", share); };
    for (const EffectInstance& decoy : comb_decoys(comb.fit.trial.effects.back())) {
        Fit moved = values_of(comb.fit);
        move_last(moved, decoy);
        const FittedSet other = fit_set(believed_, moved, comb.effects, comb.released, {}, context_, fit_options);
        if (other.fit.log_likelihood - near.log_likelihood < kDecoyShare * gain) continue;
        result_.sets[index].log_prior = -std::numeric_limits<double>::infinity();
        return;
    }
}

void SetTrials::try_relatives(std::size_t index, double share) {
    const FittedSet& fitted = result_.sets[index];
    const std::vector<Candidate> members = fitted.effects;
    const std::vector<std::string> released = fitted.released;
    Fit best;
    double highest = fitted.fit.log_posterior - kFar;
    for (const EffectInstance& relative :
         comb_relatives(fitted.fit.trial.effects.back(), longest_comb_m(*context_.observations))) {
        Fit near = values_of(fitted.fit);
        move_last(near, relative);
        const Supposition supposition = suppose(believed_, near, members, released, {}, context_);
        if (const double own = log_posterior_at(supposition.trial, supposition.unknowns, supposition.start, context_);
            own > highest)
            highest = own, best = std::move(near);
    }
    if (!best.unknowns.empty()) try_set(best, members, released, share);
}

void SetTrials::finish_best(std::size_t members) {
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

bool SetTrials::is_fitted_better(const Fit& near, const std::vector<Candidate>& members,
                                 const std::vector<std::string>& released) const {
    const auto is_it = [&](const FittedSet& set) { return set.fit.converged && has_members(set, members, released); };
    const auto known = std::find_if(result_.sets.begin(), result_.sets.end(), is_it);
    if (known == result_.sets.end()) return false;
    const Supposition supposition = suppose(believed_, near, members, released, {}, context_);
    return log_posterior_at(supposition.trial, supposition.unknowns, supposition.start, context_) <
           known->fit.log_posterior;
}

std::size_t SetTrials::prune() {
    const FittedSet& whole = leading();
    if (whole.members() < 2 || whole.score() == pruned_) return 0;
    pruned_ = whole.score();
    const Fit near = values_of(whole.fit);
    const std::vector<Candidate> members = whole.effects;
    const std::vector<std::string> released = whole.released;
    for (std::size_t i = 0; i < members.size() + released.size(); ++i) {
        std::vector<Candidate> fewer = members;
        std::vector<std::string> numbers = released;
        if (i < members.size())
            fewer.erase(fewer.begin() + static_cast<long>(i));
        else
            numbers.erase(numbers.begin() + static_cast<long>(i - members.size()));
        if (!is_fitted_better(near, fewer, numbers)) try_set(near, std::move(fewer), std::move(numbers), 0.72, true);
    }
    const std::size_t left = leading().members();
    return left < members.size() + released.size() ? left : 0;
}

void SetTrials::swap_first(const Candidate& second, const FittedSet& from, double brought, double share) {
    std::vector<const FittedSet*> singles;
    for (const FittedSet& set : result_.sets)
        if (set.effects.size() == 1 && set.released.empty() &&
            !same_variant(set.effects[0].instance, second.instance) &&
            (from.effects.empty() || !same_variant(set.effects[0].instance, from.effects[0].instance)))
            singles.push_back(&set);
    std::sort(singles.begin(), singles.end(),
              [](const FittedSet* a, const FittedSet* b) { return a->score() > b->score(); });
    if (singles.size() > kSwaps) singles.resize(kSwaps);
    std::vector<Candidate> firsts;
    std::vector<Fit> near;  // sets may move
    for (const FittedSet* single : singles) {
        // Variants of one effect are told apart as singles: the second brings the worse of them no more than the
        // better.
        const bool is_worse_kind = !from.effects.empty() &&
                                   single->effects[0].instance.effect == from.effects[0].instance.effect &&
                                   single->score() + brought < from.score();
        if (single->score() > result_.retuned.score() && !is_worse_kind)
            firsts.push_back(single->effects[0]), near.push_back(values_of(single->fit));
    }
    for (std::size_t i = 0; i < firsts.size(); ++i) try_set(near[i], {firsts[i], second}, {}, share);
}

void SetTrials::drop_needless() {
    const VerdictThresholds thresholds{.least_gain = options_.least_gain};
    drop_where([&](const FittedSet& set) {
        return std::any_of(result_.sets.begin(), result_.sets.end(),
                           [&](const FittedSet& smaller) { return adds_nothing(smaller, set, result_, thresholds); });
    });
}

void SetTrials::drop_beside(const FittedSet& smaller, double least) {
    drop_where([&](const FittedSet& set) { return extends(set, smaller) && set.score() < smaller.score() + least; });
}

void SetTrials::drop_where(const std::function<bool(const FittedSet&)>& is_dropped) {
    std::vector<bool> dropped;  // of all, before any is gone
    for (const FittedSet& set : result_.sets) dropped.push_back(is_dropped(set));
    std::vector<FittedSet> kept;
    for (std::size_t i = 0; i < dropped.size(); ++i) {
        if (dropped[i])
            result_.dropped.push_back(without_fit(result_.sets[i]));
        else
            kept.push_back(std::move(result_.sets[i]));
    }
    result_.sets = std::move(kept);
}

const FittedSet* SetTrials::best(std::size_t members) const {
    const FittedSet* found = nullptr;
    for (const FittedSet& set : result_.sets)
        if (set.members() == members && (!found || set.score() > found->score())) found = &set;
    return found;
}

const FittedSet* SetTrials::single(std::size_t nth) const {
    std::vector<const FittedSet*> singles;
    for (const FittedSet& set : result_.sets)
        if (set.effects.size() == 1 && set.released.empty() && set.score() > result_.retuned.score())
            singles.push_back(&set);
    std::sort(singles.begin(), singles.end(),
              [](const FittedSet* a, const FittedSet* b) { return a->score() > b->score(); });
    std::vector<const FittedSet*> variants;  // the best fit of each
    for (const FittedSet* own : singles)
        if (std::none_of(variants.begin(), variants.end(), [&](const FittedSet* known) {
                return same_variant(known->effects[0].instance, own->effects[0].instance);
            }))
            variants.push_back(own);
    return variants.size() < nth ? nullptr : variants[nth - 1];
}

const FittedSet& SetTrials::leading() const {
    const FittedSet* found = &result_.retuned;
    for (const FittedSet& set : result_.sets)
        if (set.score() > found->score()) found = &set;
    return *found;
}

const Fit& SetTrials::most_probable() const {
    const Fit* found = &result_.retuned.fit;
    for (const FittedSet& set : result_.sets)
        if (set.fit.log_posterior > found->log_posterior) found = &set.fit;
    return *found;
}

void SetTrials::sort() {
    std::erase_if(result_.sets, [](const FittedSet& set) { return !std::isfinite(set.score()); });
    std::stable_sort(result_.sets.begin(), result_.sets.end(),
                     [](const FittedSet& a, const FittedSet& b) { return a.score() > b.score(); });
}

}  // namespace railpem::diagnosis
