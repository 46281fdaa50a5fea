#include "diagnosis/name.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace railpem::diagnosis {

namespace {

constexpr double kLeastRelease = 3.0;           ///< nats to first order; what a wrong belief distorts is seen too small from there
constexpr double kReleasedDeviation = 1.15;     ///< half of log 10: a factor between a tenth and ten
constexpr double kLogPriorOfSomething = -0.7;   ///< something is missing as often as not
constexpr double kLogPriorOfAnother = -2.3;     ///< and one time in ten another thing beside it
constexpr double kLogPriorOfUnknown = -3.0;     ///< and one time in twenty something without a name

double prior_of(const FittedSet& set, std::size_t numbers) {
    double sum = 0.0;
    for (const Candidate& candidate : set.effects) sum += candidate.log_prior;
    for (std::size_t i = 0; i < set.released.size(); ++i) sum -= std::log(static_cast<double>(effects().size() * numbers));
    if (set.members() > 0 || !set.anonymous.empty()) sum += kLogPriorOfSomething;
    if (set.members() > 1) sum += kLogPriorOfAnother * static_cast<double>(set.members() - 1);
    if (!set.anonymous.empty()) sum += kLogPriorOfUnknown;
    return sum;
}

/// The value that a near fit has for an unknown, or its mean.
double start_of(const Unknown& unknown, const Fit& near) {
    std::size_t index = 0;
    return near.find(unknown.name, &index) ? near.values[index] : unknown.mean;
}

constexpr double kLeastShare = 0.04;  ///< of the best promise; what is weaker waits for the next round

/// What is worth a refit: per variant the two best starting points, few variants per effect.
std::vector<Candidate> worth_refitting(const std::vector<Promise>& promises, const std::vector<Candidate>& candidates, double least, int most) {
    constexpr int kVariantsPerEffect = 2;
    std::map<std::string, int> of_effect, of_variant;
    std::vector<Candidate> chosen;
    for (const Promise& promise : promises) {
        if (promise.gain < least || promise.gain < kLeastShare * promises.front().gain || static_cast<int>(chosen.size()) >= most) break;
        const EffectInstance& instance = candidates[promise.candidate].instance;
        if (of_variant[label_of(instance)]++ > 0) continue;
        if (of_effect[instance.effect]++ >= kVariantsPerEffect) continue;
        chosen.push_back(started_at(candidates[promise.candidate], promise.strength));
    }
    return chosen;
}

/// Numbers whose belief the data push against.
std::vector<std::string> worth_releasing(const Fit& fit, const std::vector<std::string>& released, double least, int most) {
    std::vector<std::pair<double, std::string>> gains;
    for (std::size_t i = 0; i < fit.unknowns.size(); ++i) {
        if (fit.unknowns[i].kind != UnknownKind::number) continue;
        if (std::find(released.begin(), released.end(), fit.unknowns[i].name) != released.end()) continue;
        const double gain = release_gain(fit, i, kReleasedDeviation);
        if (gain > least) gains.emplace_back(gain, fit.unknowns[i].name);
    }
    std::sort(gains.rbegin(), gains.rend());
    std::vector<std::string> keys;
    for (const auto& [gain, key] : gains)
        if (static_cast<int>(keys.size()) < most) keys.push_back(key);
    return keys;
}

/// Thrown between steps when somebody wants to end the search.
struct Interrupted {};

constexpr double kBluntFloor = 0.1;
constexpr int kBluntIterations = 2;

/// Typical values, and every parameter in turn near either end of its range.
std::vector<Candidate> starts_of(const Candidate& candidate) {
    constexpr double kNearEnd = 0.2;
    const Effect& effect = *find_effect(candidate.instance.effect);
    Candidate typical = candidate;
    for (const EffectParameter& parameter : effect.parameters) typical.instance.values[parameter.name] = parameter.typical;
    std::vector<Candidate> starts{typical};
    for (const EffectParameter& parameter : effect.parameters)
        for (const double share : {kNearEnd, 1.0 - kNearEnd}) {
            const double low = to_coordinate(parameter, parameter.low), high = to_coordinate(parameter, parameter.high);
            starts.push_back(typical);
            starts.back().instance.values[parameter.name] = from_coordinate(parameter, low + share * (high - low));
        }
    return starts;
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
        result_.first_promises = screen(result_.retuned.fit, result_.candidates, context_);
        first_round();
        further_rounds();
        if (left_over() < options_.residual) return;
        const double before = best_score();
        rescue_round();
        if (best_score() < before + options_.least_gain) return;
        further_rounds();
        left_over();
    }

    void further_rounds() {
        for (int members = 2; members <= options_.most_effects; ++members)
            if (!further_round(members)) break;
    }

    double best_score() const {
        double score = result_.retuned.score();
        for (const FittedSet& set : result_.sets) score = std::max(score, set.score());
        return score;
    }

    /// Nats that a free correction would still bring beside the best set.
    double left_over() {
        say("what is left", 0.7);
        sort_sets();
        const bool named = !result_.sets.empty() && result_.sets.front().score() > result_.retuned.score();
        std::vector<LocatedEvidence> left = locate(named ? result_.sets.front().fit : result_.retuned.fit, context_);
        const double most = left.empty() ? 0.0 : left.front().nats;
        if (named) result_.left_by_best = std::move(left);
        else left_by_retuned_ = std::move(left);
        return most;
    }

    /// A strong effect distorts the retuned case so much that no first derivative finds it from there. Effects of the evident
    /// places are fitted as the retuned case was: from the believed numbers, at a typical strength, with a blunt likelihood first.
    void rescue_round() {
        const std::vector<LocatedEvidence>& left = result_.left_by_best.empty() ? left_by_retuned_ : result_.left_by_best;
        constexpr double kEvident = 0.1;  ///< share of the most evident place's nats
        const auto is_evident = [&](Element element) {
            if (element == Element::support) element = Element::pad;  // rigid ground has no correction of its own
            return std::any_of(left.begin(), left.end(), [&](const LocatedEvidence& own) { return own.place.element == element && own.nats > kEvident * left.front().nats; });
        };
        std::vector<std::string> done;
        for (const Candidate& candidate : result_.candidates) {
            const Effect& effect = *find_effect(candidate.instance.effect);
            const Element element = element_of(effect, candidate.instance);
            if (element == Element::sensor || element == Element::irregularity || effect.id == "wheel-out-of-roundness" || effect.id == "failed-fasteners") continue;
            const std::string label = label_of(candidate.instance);
            if (!is_evident(element) || std::find(done.begin(), done.end(), label) != done.end()) continue;
            done.push_back(label);
            try_from_afar(candidate);
        }
    }

    void say(const std::string& what, double share) {
        if (options_.progress) options_.progress(what, share);
        if (options_.interrupted && options_.interrupted()) throw Interrupted{};
    }

    /// Several starts with a likelihood that is blunt enough to be smooth; the best of them is then sharpened.
    void try_from_afar(const Candidate& candidate) {
        const std::string label = label_of(candidate.instance) + " from afar";
        FitOptions blunt_options{.iterations = kBluntIterations, .from_far = false};
        blunt_options.between = [this, label] { say(label, 0.7); };
        LikelihoodContext blunt = context_;
        blunt.least_floor = kBluntFloor;
        FittedSet best;
        for (const Candidate& start : starts_of(candidate)) {
            FittedSet set = fit_set(believed_, Fit{}, {start}, {}, {}, blunt, blunt_options);
            if (best.effects.empty() || set.fit.log_posterior > best.fit.log_posterior) best = std::move(set);
        }
        FitOptions sharp_options{.iterations = 20, .stages = {0.1, 0.04, 0.015, 0.006, 0.0025}, .stage_iterations = 5};
        sharp_options.between = blunt_options.between;
        result_.sets.push_back(fit_set(believed_, best.fit, best.effects, {}, {}, context_, sharp_options));
    }

    void retune() {
        const Trial trial = believed_trial(believed_, *context_.observations);
        std::vector<Unknown> unknowns = nuisance_unknowns(believed_, *context_.observations);
        const std::vector<double> start = means(unknowns);
        FitOptions fit_options;
        fit_options.between = [this] { say("retuning", 0.05); };
        result_.retuned.fit = fit(trial, std::move(unknowns), start, context_, fit_options);
        result_.retuned.held_out = part_log_likelihood(result_.retuned.fit, context_, Part::held_out);
    }

    const FittedSet& try_set(const Fit& near, std::vector<Candidate> members, std::vector<std::string> released, double share) {
        std::string text;
        for (const Candidate& member : members) text += (text.empty() ? "" : " + ") + label_of(member.instance);
        for (const std::string& key : released) text += (text.empty() ? "" : " + ") + key;
        say(text, share);
        FitOptions fit_options;
        fit_options.between = [this, text, share] { say(text, share); };
        fit_options.from_far = false;
        result_.sets.push_back(fit_set(believed_, near, std::move(members), std::move(released), {}, context_, fit_options));
        return result_.sets.back();
    }

    void first_round() {
        const std::vector<Candidate> chosen = worth_refitting(result_.first_promises, result_.candidates, options_.least_promise, options_.refits);
        const std::vector<std::string> keys = worth_releasing(result_.retuned.fit, {}, kLeastRelease, 2);
        const double step = 0.4 / static_cast<double>(chosen.size() + keys.size() + 1);
        double share = 0.25;
        for (const Candidate& candidate : chosen) try_set(result_.retuned.fit, {candidate}, {}, share += step);
        for (const std::string& key : keys) try_set(result_.retuned.fit, {}, {key}, share += step);
    }

    const FittedSet* best(std::size_t members) const {
        const FittedSet* found = nullptr;
        for (const FittedSet& set : result_.sets)
            if (set.members() == members && (!found || set.score() > found->score())) found = &set;
        return found;
    }

    /// Adds a member to the best smaller set, then swaps the others. False when nothing was gained.
    bool further_round(int members) {
        const FittedSet* base = best(static_cast<std::size_t>(members - 1));
        const double smaller = members == 2 ? result_.retuned.score() : best(static_cast<std::size_t>(members - 2))->score();
        if (!base || base->score() < smaller + options_.least_gain) return false;
        const FittedSet from = *base;
        const double share = 0.65 + 0.1 * (members - 2);
        const std::vector<Promise> promises = screen(from.fit, result_.candidates, context_);
        std::vector<Candidate> chosen = worth_refitting(promises, result_.candidates, options_.least_promise, options_.later_refits + 2);
        const auto is_member = [&](const Candidate& candidate) {
            return std::any_of(from.effects.begin(), from.effects.end(),
                               [&](const Candidate& own) { return same_variant(own.instance, candidate.instance); });
        };
        std::erase_if(chosen, is_member);
        if (static_cast<int>(chosen.size()) > options_.later_refits) chosen.erase(chosen.begin() + options_.later_refits, chosen.end());
        const Candidate* winner = nullptr;
        double highest = -1e300;
        for (const Candidate& candidate : chosen) {
            std::vector<Candidate> with = from.effects;
            with.push_back(candidate);
            const double score = try_set(from.fit, with, from.released, share).score();
            if (score > highest) highest = score, winner = &candidate;
        }
        for (const std::string& key : worth_releasing(from.fit, from.released, kLeastRelease, 1)) {
            std::vector<std::string> released = from.released;
            released.push_back(key);
            try_set(from.fit, from.effects, released, share);
        }
        if (members == 2 && winner && highest > from.score() + options_.least_gain) swap_first(*winner, from, share);
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
        std::stable_sort(result_.sets.begin(), result_.sets.end(), [](const FittedSet& a, const FittedSet& b) { return a.score() > b.score(); });
    }

    const BelievedCase& believed_;
    const LikelihoodContext& context_;
    const NamingOptions& options_;
    NamingResult& result_;
    std::vector<LocatedEvidence> left_by_retuned_;
};

}  // namespace

double part_log_likelihood(const Fit& fit, const LikelihoodContext& context, Part part) {
    LikelihoodContext other = context;
    other.part = part;
    return log_likelihood(fit.trial, fit.predictions, other);
}

FittedSet fit_set(const BelievedCase& believed, const Fit& near, std::vector<Candidate> members, std::vector<std::string> released,
                  std::vector<CorrectionPlace> anonymous, const LikelihoodContext& context, const FitOptions& options) {
    FittedSet set{.effects = std::move(members), .released = std::move(released), .anonymous = std::move(anonymous)};
    Trial trial = believed_trial(believed, *context.observations);
    std::vector<Unknown> unknowns = nuisance_unknowns(believed, *context.observations);
    for (Unknown& unknown : unknowns)
        if (std::find(set.released.begin(), set.released.end(), unknown.name) != set.released.end()) unknown.deviation = kReleasedDeviation;
    std::vector<double> start;
    for (const Unknown& unknown : unknowns) start.push_back(start_of(unknown, near));
    for (const Candidate& member : set.effects) {
        const std::vector<Unknown> own = effect_unknowns(member.instance, trial.effects.size());
        const Effect& effect = *find_effect(member.instance.effect);
        for (const Unknown& unknown : own) {
            // A member of the near fit starts where that fit left it, a new one at its mild strength.
            const std::string name = unknown.name.substr(unknown.name.find('.') + 1);
            double value = member.instance.values.count(name) ? member.instance.values.at(name) : value_of(effect, member.instance, name);
            for (const EffectInstance& instance : near.trial.effects)
                if (same_variant(instance, member.instance) && instance.values.count(name)) value = instance.values.at(name);
            for (const EffectParameter& parameter : effect.parameters)
                if (parameter.name == name) start.push_back(std::clamp(to_coordinate(parameter, value), unknown.low, unknown.high));
        }
        unknowns.insert(unknowns.end(), own.begin(), own.end());
        trial.effects.push_back(member.instance);
    }
    for (const CorrectionPlace& place : set.anonymous)
        for (Unknown& unknown : correction_unknowns(place, *context.observations)) {
            start.push_back(unknown.mean);
            unknowns.push_back(std::move(unknown));
        }
    set.fit = fit(trial, std::move(unknowns), std::move(start), context, options);
    set.log_prior = prior_of(set, believed.uncertain.size());
    set.held_out = part_log_likelihood(set.fit, context, Part::held_out);
    return set;
}

NamingResult name_physics(const BelievedCase& believed, const LikelihoodContext& context, const NamingOptions& options) {
    NamingResult result;
    Search(believed, context, options, result).run();
    return result;
}

}  // namespace railpem::diagnosis
