#include "diagnosis/from_afar.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

namespace railpem::diagnosis {

namespace {

constexpr double kBluntFloor = 0.1;
constexpr const char* kTuned = "frequency_hz";
constexpr std::size_t kClimbed = 3;         ///< of the starts, those most probable as they stand
constexpr int kBluntIterations = 2;
constexpr int kFurtherBluntIterations = 6;  ///< of an effect's best start
constexpr int kStepsOfAStage = 5;           ///< of sharpening

/// Typical values, every parameter in turn near either end of its range, and the frequencies in question: something tuned is not found from half of its frequency.
std::vector<Candidate> starts_of(const std::vector<Candidate>& variants) {
    constexpr double kNearEnd = 0.2;
    const Effect& effect = *find_effect(variants.front().instance.effect);
    Candidate typical = variants.front();
    for (const EffectParameter& parameter : effect.parameters) typical.instance.values[parameter.name] = parameter.typical;
    std::vector<Candidate> starts{typical};
    const auto start_at = [&](const std::string& parameter, double value) {
        starts.push_back(typical);
        starts.back().instance.values[parameter] = value;
    };
    for (const EffectParameter& parameter : effect.parameters) {
        if (parameter.name == kTuned)
            for (const Candidate& own : variants) start_at(kTuned, own.instance.values.at(kTuned));
        else
            for (const double share : {kNearEnd, 1.0 - kNearEnd}) {
                const double low = to_coordinate(parameter, parameter.low), high = to_coordinate(parameter, parameter.high);
                start_at(parameter.name, from_coordinate(parameter, low + share * (high - low)));
            }
    }
    return starts;
}

/// Whether an effect comes in many numbered variants (orders of a wheel, every n-th seat): those are told by their lines, which the first
/// derivative sees wherever the fit stands.
bool is_numbered(const Effect& effect) {
    return std::any_of(effect.choices.begin(), effect.choices.end(), [](const EffectChoice& choice) { return choice.whole_number; });
}

}  // namespace

std::vector<std::vector<Candidate>> variants_from_afar(const std::vector<Candidate>& candidates, const std::vector<Candidate>& members,
                                                       const std::function<bool(Element)>& evident) {
    std::map<std::string, std::size_t> places;
    std::vector<std::vector<Candidate>> variants;
    for (const Candidate& candidate : candidates) {
        const Effect& effect = *find_effect(candidate.instance.effect);
        const Element element = element_of(effect, candidate.instance);
        if (element == Element::sensor || element == Element::irregularity || element == Element::contact || is_numbered(effect)) continue;
        if (!evident(element) && !effect.follows_load) continue;
        const auto is_it = [&](const Candidate& own) { return same_variant(own.instance, candidate.instance); };
        if (std::count_if(members.begin(), members.end(), is_it) >= effect.most_instances) continue;
        const auto [place, is_new] = places.try_emplace(label_of(candidate.instance), variants.size());
        if (is_new) variants.emplace_back();
        variants[place->second].push_back(candidate);
    }
    return variants;
}

FittedSet blunt_from_afar(const BelievedCase& believed, const std::vector<Candidate>& members, const std::vector<Candidate>& variants,
                          const LikelihoodContext& context, const std::function<void()>& between) {
    FitOptions options{.iterations = kBluntIterations, .from_far = false};
    options.between = between;
    const LikelihoodContext blunt = blunted(context, kBluntFloor);
    std::vector<std::pair<double, std::vector<Candidate>>> starts;
    for (const Candidate& start : starts_of(variants)) {
        std::vector<Candidate> set = members;
        set.push_back(start);
        const Supposition supposition = suppose(believed, Fit{}, set, {}, {}, blunt);
        starts.emplace_back(log_posterior_at(supposition.trial, supposition.unknowns, supposition.start, blunt), std::move(set));
    }
    std::stable_sort(starts.begin(), starts.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    FittedSet best;
    for (std::size_t i = 0; i < std::min(kClimbed, starts.size()); ++i) {
        FittedSet set = fit_set(believed, Fit{}, starts[i].second, {}, {}, blunt, options);
        if (best.effects.empty() || set.fit.log_posterior > best.fit.log_posterior) best = std::move(set);
    }
    options.iterations = kFurtherBluntIterations;
    best = fit_set(believed, best.fit, best.effects, {}, {}, blunt, options);
    best.fit.derivatives.reset();  // several of these wait for each other
    return best;
}

FittedSet half_sharpened(const BelievedCase& believed, const FittedSet& blunt, const LikelihoodContext& context, const std::function<void()>& between) {
    FitOptions options{.iterations = kStepsOfAStage, .stages = {kBluntFloor}, .stage_iterations = kStepsOfAStage};
    options.between = between;
    const LikelihoodContext half = blunted(context, kHalfSharpFloor);
    return fit_set(believed, blunt.fit, blunt.effects, blunt.released, {}, half, options);
}

FittedSet sharpened(const BelievedCase& believed, const FittedSet& half_sharp, const LikelihoodContext& context, const std::function<void()>& between) {
    FitOptions options{.iterations = 20, .stages = {0.015, 0.006, 0.0025}, .stage_iterations = kStepsOfAStage};
    options.between = between;
    const Fit values{.trial = half_sharp.fit.trial, .unknowns = half_sharp.fit.unknowns, .values = half_sharp.fit.values};  // its derivatives are of short windows
    return fit_set(believed, values, half_sharp.effects, half_sharp.released, {}, context, options);
}

}  // namespace railpem::diagnosis
