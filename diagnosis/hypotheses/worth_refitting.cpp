#include "diagnosis/hypotheses/worth_refitting.hpp"

#include <algorithm>
#include <map>

#include "diagnosis/hypotheses/fitted_set.hpp"

namespace railpem::diagnosis {

namespace {

/// of something that is there as a whole or not: when the data ask for less of it, they ask for something else
constexpr double kLeastWhole = 0.1;
/// of the best promise of its kind (sensor or structure); what is weaker waits for the next round
constexpr double kLeastShare = 0.04;
constexpr double kLeastShareOfAll = 0.01;  ///< and of the best of all

/// The effect and what of it is chosen: fasteners that fail at random are another kind than every n-th.
std::string kind_of(const EffectInstance& instance) {
    std::string kind = instance.effect;
    for (const auto& [name, value] : instance.choices) kind += ' ' + name;
    return kind;
}

}  // namespace

std::vector<Starts> worth_refitting(const std::vector<Promise>& promises, const std::vector<Candidate>& candidates,
                                    double least, int most) {
    constexpr int kVariantsPerKind = 2;
    constexpr std::size_t kStartsPerVariant = 3;
    std::map<std::string, int> of_kind;
    std::map<std::string, std::size_t> of_variant;
    std::map<bool, double> best_of_kind;
    std::vector<Starts> chosen;
    const double of_a_belief = std::max(std::min(least, kLeastOfABelief), least / kMostOfABelief);
    for (const Promise& promise : promises) {
        const EffectInstance& instance = candidates[promise.candidate].instance;
        if (promise.gain < (find_effect(instance.effect)->retuned ? of_a_belief : least)) continue;
        const double best =
            best_of_kind
                .try_emplace(element_of(*find_effect(instance.effect), instance) == Element::sensor, promise.gain)
                .first->second;
        if (promise.gain < std::max(kLeastShare * best, kLeastShareOfAll * promises.front().gain)) continue;
        if (!find_effect(instance.effect)->replaces && candidates[promise.candidate].whole &&
            !candidates[promise.candidate].read_off && promise.strength < kLeastWhole)
            continue;
        if (find_effect(instance.effect)->replaces && promise.gain < kLeastReplacing) continue;
        if (const auto known = of_variant.find(label_of(instance)); known != of_variant.end()) {
            if (chosen[known->second].size() < kStartsPerVariant) chosen[known->second].push_back(promise);
            continue;
        }
        if (static_cast<int>(chosen.size()) >= most || of_kind[kind_of(instance)]++ >= kVariantsPerKind) continue;
        of_variant[label_of(instance)] = chosen.size();
        chosen.push_back({promise});
    }
    return chosen;
}

std::vector<Starts> climbed_apart(const Starts& starts, const std::vector<Candidate>& candidates) {
    constexpr std::size_t kDistances = 2;
    const std::vector<EffectParameter>& parameters =
        find_effect(candidates[starts.front().candidate].instance.effect)->parameters;
    if (std::none_of(parameters.begin(), parameters.end(), [](const EffectParameter& own) { return own.comb; }))
        return {starts};
    std::vector<Starts> apart;
    for (std::size_t i = 0; i < std::min(kDistances, starts.size()); ++i) apart.push_back({starts[i]});
    return apart;
}

void add_replacing(const std::vector<Promise>& promises, const std::vector<Candidate>& candidates,
                   const std::vector<std::string>& released, std::vector<Starts>& chosen) {
    const auto element = [&](const Promise& promise) {
        const EffectInstance& instance = candidates[promise.candidate].instance;
        return element_of(*find_effect(instance.effect), instance);
    };
    for (const Promise& promise : promises) {
        if (!find_effect(candidates[promise.candidate].instance.effect)->replaces) continue;
        const bool there = std::any_of(chosen.begin(), chosen.end(),
                                       [&](const Starts& own) { return own.front().candidate == promise.candidate; });
        const bool wanted = std::any_of(chosen.begin(), chosen.end(),
                                        [&](const Starts& own) { return element(own.front()) == element(promise); }) ||
                            std::any_of(released.begin(), released.end(), [&](const std::string& key) {
                                return element_of_key(key) == element(promise);
                            });
        if (wanted && !there) chosen.push_back({promise});
    }
}

void add_unpromised(const std::vector<Promise>& promises, const std::vector<Candidate>& candidates,
                    std::vector<Starts>& chosen) {
    for (const Promise& promise : promises) {
        const EffectInstance& instance = candidates[promise.candidate].instance;
        if (!find_effect(instance.effect)->replaces || promise.gain < kLeastReplacing) continue;
        const auto same = [&](const Starts& own) {
            return same_variant(candidates[own.front().candidate].instance, instance);
        };
        if (std::none_of(chosen.begin(), chosen.end(), same)) chosen.push_back({promise});
    }
}

std::vector<std::string> worth_releasing(const Fit& fit, const std::vector<std::string>& released, double least,
                                         int most) {
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

}  // namespace railpem::diagnosis
