#include "diagnosis/search/from_afar.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "diagnosis/fit/climb.hpp"
#include "diagnosis/hypotheses/locate.hpp"

namespace railpem::diagnosis {

namespace {

constexpr double kBluntFloor = kFitSettings.ladder.front();
constexpr const char* kTuned = "frequency_hz";
constexpr std::size_t kClimbed = 2;  ///< of the starts, those most probable once the numbers have followed them
/// effects that approached highest: one of both effects of the paper was the third of them (seed 9601 of
/// scripts/hide_and_seek.py)
constexpr std::size_t kClimbedAnyway = 4;
/// of the bins, in which starts are compared: what is not near the top yet is not told apart by neighbours
constexpr std::size_t kEvery = 3;
constexpr int kBluntIterations = 2;
constexpr int kFurtherBluntIterations = 6;    ///< of an effect's best start, and of the case without it
constexpr std::size_t kBluntCorrections = 3;  ///< places whose free correction is fitted bluntly
constexpr std::size_t kSharpCorrections = 2;  ///< and sharpened,
constexpr double kNearBest = 0.5;             ///< of what the best brings bluntly, the second has to bring
constexpr int kStepsOfAStage = 5;             ///< of sharpening

constexpr double kNearEnd = 0.2;

double within_range(const EffectParameter& parameter, double share) {
    const double low = to_coordinate(parameter, parameter.low), high = to_coordinate(parameter, parameter.high);
    return from_coordinate(parameter, low + share * (high - low));
}

/// An instance near the end of the range of every strength that lies far from `nothing`.
EffectInstance strong(const Effect& effect, EffectInstance instance) {
    for (const EffectParameter& parameter : effect.parameters) {
        if (!parameter.strength) continue;
        const bool fades_upwards = parameter.nothing > 0.5 * (parameter.low + parameter.high);
        instance.values[parameter.name] = within_range(parameter, fades_upwards ? kNearEnd : 1.0 - kNearEnd);
    }
    return instance;
}

/// Near the ends of all ranges, in every combination: a light sleeper on stiff ballast that hardly damps was not found
/// from either end of one of them.
std::vector<EffectInstance> corners(const Effect& effect, const EffectInstance& typical) {
    std::vector<EffectInstance> corners{typical};
    for (const EffectParameter& parameter : effect.parameters) {
        if (parameter.law) continue;
        std::vector<EffectInstance> doubled;
        for (const EffectInstance& own : corners)
            for (const double share : {kNearEnd, 1.0 - kNearEnd}) {
                doubled.push_back(own);
                doubled.back().values[parameter.name] = within_range(parameter, share);
            }
        corners = std::move(doubled);
    }
    return corners;
}

bool is_tuned(const Effect& effect) {
    return std::any_of(effect.parameters.begin(), effect.parameters.end(),
                       [](const EffectParameter& own) { return own.name == kTuned; });
}

/// Typical values, every parameter in turn near either end of its range, and those together; of what is tuned the
/// frequencies in question, typical and strong: it is not found from half of its frequency, nor what is strong from
/// what is not (axles that bend at 57 Hz with a modal mass of 0.5 t from either alone).
std::vector<Candidate> starts_of(const std::vector<Candidate>& variants) {
    const Effect& effect = *find_effect(variants.front().instance.effect);
    Candidate typical = variants.front();
    for (const EffectParameter& parameter : effect.parameters)
        typical.instance.values[parameter.name] = parameter.typical;
    std::vector<Candidate> starts{typical};
    const auto start_at = [&](EffectInstance instance) {
        starts.push_back(typical), starts.back().instance = std::move(instance);
    };
    const auto with = [&](const std::string& parameter, double value) {
        EffectInstance instance = typical.instance;
        instance.values[parameter] = value;
        return instance;
    };
    for (const EffectParameter& parameter : effect.parameters) {
        if (parameter.name == kTuned || parameter.law) continue;
        for (const double share : {kNearEnd, 1.0 - kNearEnd})
            start_at(with(parameter.name, within_range(parameter, share)));
    }
    if (is_tuned(effect)) {
        for (const Candidate& own : variants) {
            const EffectInstance tuned = with(kTuned, own.instance.values.at(kTuned));
            start_at(tuned);
            start_at(strong(effect, tuned));
        }
    } else if (effect.parameters.size() > 1) {
        for (EffectInstance& corner : corners(effect, typical.instance)) start_at(std::move(corner));
    }
    return starts;
}

/// Whether an effect comes in many numbered variants (orders of a wheel, every n-th seat): those are told by their
/// lines, which the first derivative sees wherever the fit stands.
bool is_numbered(const Effect& effect) {
    return std::any_of(effect.choices.begin(), effect.choices.end(),
                       [](const EffectChoice& choice) { return choice.whole_number; });
}

/// An effect at some strength, and the numbers that go with it: values and log-posterior only, with the derivatives
/// that led there.
struct Start {
    std::vector<Candidate> set;
    Fit near;
};

/// The most probable of an effect's starts, near a log-posterior of `least`, approached by the derivatives of the case
/// without it.
std::vector<Start> approached(const BelievedCase& believed, const Fit& without, const std::vector<Candidate>& members,
                              const std::vector<Candidate>& variants, const LikelihoodContext& blunt, double least,
                              const std::function<void(const Candidate&)>& between) {
    std::vector<Start> starts;
    for (const Candidate& candidate : starts_of(variants)) {
        between(candidate);
        Start own{.set = members, .near = {}};
        own.set.push_back(candidate);
        Supposition supposed = suppose(believed, without, own.set, {}, {}, blunt);
        const double rival = starts.size() < kClimbed ? least : std::max(least, starts.back().near.log_posterior);
        Approach there =
            approach(supposed.trial, supposed.unknowns, std::move(supposed.start), *without.derivatives, blunt, rival);
        own.near.trial = std::move(supposed.trial);
        own.near.unknowns = std::move(supposed.unknowns);
        own.near.values = std::move(there.values);
        own.near.log_posterior = there.log_posterior;
        own.near.derivatives = without.derivatives;
        starts.push_back(std::move(own));
        std::stable_sort(starts.begin(), starts.end(),
                         [](const Start& a, const Start& b) { return a.near.log_posterior > b.near.log_posterior; });
        if (starts.size() > kClimbed) starts.pop_back();
    }
    return starts;
}

FittedSet climbed(const BelievedCase& believed, const std::vector<Start>& starts, const Fit* rival,
                  const LikelihoodContext& blunt, const std::function<void(const Candidate&)>& between) {
    FitOptions options{.iterations = kBluntIterations, .from_far = false, .rival = rival};
    options.between = [&] { between(starts.front().set.back()); };
    FittedSet best;
    for (const Start& start : starts) {
        FittedSet set = fit_set(believed, start.near, start.set, {}, {}, blunt, options);
        if (best.effects.empty() || set.fit.log_posterior > best.fit.log_posterior) best = std::move(set);
        // of two starts one is enough
        if (!options.rival || best.fit.log_posterior > options.rival->log_posterior) options.rival = &best.fit;
    }
    options.iterations = kFurtherBluntIterations;
    options.rival = rival;
    if (!best.fit.converged) best = fit_set(believed, best.fit, best.effects, {}, {}, blunt, options);
    best.fit.derivatives.reset();  // several of these wait for each other
    return best;
}

}  // namespace

std::vector<std::vector<Candidate>> variants_from_afar(const std::vector<Candidate>& candidates,
                                                       const std::vector<Candidate>& members,
                                                       const std::function<bool(Element)>& evident) {
    std::map<std::string, std::size_t> places;
    std::vector<std::vector<Candidate>> variants;
    for (const Candidate& candidate : candidates) {
        const Effect& effect = *find_effect(candidate.instance.effect);
        const Element element = element_of(effect, candidate.instance);
        if (element == Element::sensor || element == Element::irregularity || element == Element::contact ||
            is_numbered(effect))
            continue;
        if (!evident(element) && !effect.follows_load) continue;
        const auto is_it = [&](const Candidate& own) { return same_variant(own.instance, candidate.instance); };
        if (std::count_if(members.begin(), members.end(), is_it) >= effect.most_instances) continue;
        const auto [place, is_new] = places.try_emplace(label_of(candidate.instance), variants.size());
        if (is_new) variants.emplace_back();
        variants[place->second].push_back(candidate);
    }
    return variants;
}

std::vector<FittedSet> blunt_from_afar(const BelievedCase& believed, const Fit& near,
                                       const std::vector<Candidate>& members,
                                       const std::vector<std::vector<Candidate>>& variants,
                                       const LikelihoodContext& context,
                                       const std::function<void(const Candidate&)>& between,
                                       const std::function<bool()>& enough, const Fit* rival) {
    if (variants.empty()) return {};
    const LikelihoodContext blunt = blunted(context, kBluntFloor);
    const Fit without =
        fit_set(believed, near, members, {}, {}, blunt, {.iterations = kFurtherBluntIterations, .from_far = false}).fit;
    if (!without.derivatives) return {};  // physics forbids the members as they stand
    LikelihoodContext sparse = blunt;
    sparse.every = kEvery;
    const double least =
        rival ? log_likelihood(rival->trial, rival->predictions, sparse) + log_belief(rival->unknowns, rival->values)
              : -std::numeric_limits<double>::infinity();
    std::vector<std::vector<Start>> starts;
    for (const std::vector<Candidate>& own : variants)
        starts.push_back(approached(believed, without, members, own, sparse, least, between));
    // The case without any, where starts are compared.
    const double nothing =
        log_likelihood(without.trial, without.predictions, sparse) + log_belief(without.unknowns, without.values);
    const auto height = [](const std::vector<Start>& own) { return own.front().near.log_posterior; };
    std::stable_sort(starts.begin(), starts.end(), [&](const auto& a, const auto& b) { return height(a) > height(b); });
    std::vector<FittedSet> sets;
    sets.reserve(starts.size());  // the rival is one of them
    for (const std::vector<Start>& own : starts) {
        if (sets.size() >= kClimbedAnyway && (height(own) < nothing || enough())) break;
        sets.push_back(climbed(believed, own, rival, blunt, between));
        if (!rival || sets.back().fit.log_posterior > rival->log_posterior) rival = &sets.back().fit;
    }
    return sets;
}

BluntCorrections blunt_corrections(const BelievedCase& believed, const LikelihoodContext& context,
                                   const std::function<void(const std::string&)>& between) {
    const LikelihoodContext blunt = blunted(context, kBluntFloor);
    FitOptions options{.iterations = kFurtherBluntIterations, .from_far = false};
    const FittedSet retuned = fit_set(believed, Fit{}, {}, {}, {}, blunt, options);
    between("locating in the structure, bluntly");
    const std::vector<LocatedEvidence> located = locate(retuned.fit, blunt);
    std::vector<FittedSet> sets;
    for (std::size_t i = 0; i < std::min(kBluntCorrections, located.size()); ++i) {
        const std::string what = "free correction of the " + element_name(located[i].place.element) + " from afar";
        between(what);
        options.between = [&] { between(what); };
        sets.push_back(fit_correction(believed, retuned, located[i], blunt, options));
    }
    std::stable_sort(sets.begin(), sets.end(),
                     [](const FittedSet& a, const FittedSet& b) { return a.score() > b.score(); });
    // they may never be asked for, and are a hundred megabytes each
    for (std::size_t i = 1; i < sets.size(); ++i) sets[i].fit.derivatives.reset();
    return {std::move(sets), retuned.score()};
}

std::vector<FittedSet> sharpened_corrections(const BelievedCase& believed, const BluntCorrections& blunt,
                                             const LikelihoodContext& context,
                                             const std::function<void(const std::string&)>& between,
                                             const std::function<bool()>& enough, const Fit* rival) {
    std::vector<FittedSet> sets;
    sets.reserve(kSharpCorrections);  // the rival is one of them
    for (const FittedSet& own : blunt.sets) {
        const bool is_near = own.score() - blunt.nothing >= kNearBest * (blunt.sets.front().score() - blunt.nothing);
        if (sets.size() == kSharpCorrections || !is_near || (!sets.empty() && enough())) break;
        const auto step = [&] {
            between("free correction of the " + element_name(own.anonymous.front().element) + ", sharpened");
        };
        FittedSet half = half_sharpened(believed, own, context, step);
        half.fit.derivatives.reset();  // of short windows; those of long ones need the room
        sets.push_back(sharpened(believed, half, context, step, rival));
        sets.back().fit.derivatives.reset();
        if (!rival || sets.back().fit.log_posterior > rival->log_posterior) rival = &sets.back().fit;
    }
    return sets;
}

FittedSet half_sharpened(const BelievedCase& believed, const FittedSet& blunt, const LikelihoodContext& context,
                         const std::function<void()>& between) {
    FitOptions options{.iterations = kStepsOfAStage, .stages = {kBluntFloor}, .stage_iterations = kStepsOfAStage};
    options.between = between;
    const LikelihoodContext half = blunted(context, kHalfSharpFloor);
    return fit_set(believed, blunt.fit, blunt.effects, blunt.released, blunt.anonymous, half, options);
}

FittedSet sharpened(const BelievedCase& believed, const FittedSet& half_sharp, const LikelihoodContext& context,
                    const std::function<void()>& between, const Fit* rival) {
    FitOptions options{.stages = {0.015, 0.006, 0.0025}, .stage_iterations = kStepsOfAStage, .rival = rival};
    options.between = between;
    // its derivatives are of short windows
    const Fit values{
        .trial = half_sharp.fit.trial, .unknowns = half_sharp.fit.unknowns, .values = half_sharp.fit.values};
    return fit_set(believed, values, half_sharp.effects, half_sharp.released, half_sharp.anonymous, context, options);
}

}  // namespace railpem::diagnosis
