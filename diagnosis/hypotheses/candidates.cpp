#include "diagnosis/hypotheses/candidates.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "diagnosis/hypotheses/proposers/comb_relatives.hpp"
#include "diagnosis/observations/shows.hpp"
#include "pem/response_names.hpp"

namespace railpem::diagnosis {

namespace {

constexpr int kFrequencyPoints = 10;  ///< of a grid over a frequency or wavelength
/// of a grid over wavelengths, relative: as narrow as the bands that are looked for. A band of 5 % between points of 12
/// % went unseen, or was taken for a wide one elsewhere
constexpr double kWavelengthStep = 0.05;
constexpr int kOtherPoints = 3;
constexpr double kMildShare = 0.3;  ///< of the way from the weak end of a strength's range
constexpr double kMildGain = 1.05, kMildDelay_s = 0.5e-3;

/// The widest band that any recording offers, Hz.
std::pair<double, double> common_band(const std::vector<Observation>& observations) {
    double low = 1e300, high = 0.0;
    for (const Observation& observation : observations) {
        low = std::min(low, observation.expectation.low_hz);
        high = std::max(high, observation.expectation.high_hz);
    }
    return {low, high};
}

std::vector<double> grid(const EffectParameter& parameter, double low, double high, int points) {
    std::vector<double> values;
    for (int i = 0; i < points; ++i) {
        const double share = points == 1 ? 0.5 : static_cast<double>(i) / (points - 1);
        values.push_back(parameter.spread == Spread::logarithmic || low > 0.0 ? low * std::pow(high / low, share)
                                                                              : low + share * (high - low));
    }
    return values;
}

/// One of several strengths that may go either way: each may be there without the others.
bool is_one_of_several(const Effect& effect, const EffectParameter& parameter) {
    const auto goes_either_way = [](const EffectParameter& own) {
        return own.strength && own.nothing > own.low && own.nothing < own.high;
    };
    return goes_either_way(parameter) &&
           std::count_if(effect.parameters.begin(), effect.parameters.end(), goes_either_way) > 1;
}

bool is_at_nothing(const EffectParameter& parameter, const EffectInstance& instance) {
    return parameter.strength && instance.values.count(parameter.name) &&
           instance.values.at(parameter.name) == parameter.nothing;
}

/// Values of a parameter from which to look.
std::vector<double> looking_points(const Effect& effect, const EffectParameter& parameter,
                                   const std::vector<Observation>& observations) {
    if (parameter.name == "gain") return {kMildGain, -1.0};
    if (parameter.name == "delay_s") return {kMildDelay_s};
    if (parameter.name == "frequency_hz") {
        const auto [low, high] = common_band(observations);
        const double from = std::max(parameter.low, 0.9 * low), to = std::min(parameter.high, 1.5 * high);
        if (from >= to) return {parameter.typical};
        return grid(parameter, from, to, kFrequencyPoints);
    }
    if (parameter.name == "wavelength_m" || parameter.name == "spacing_m") {
        double shortest = 1e300, longest = 0.0;
        for (const Observation& observation : observations) {
            if (!reaches(observation, Element::irregularity)) continue;
            shortest = std::min(shortest, observation.speed_m_per_s / observation.expectation.high_hz);
            longest = std::max(longest, observation.speed_m_per_s / observation.expectation.low_hz);
        }
        if (parameter.comb) {  // shows by its harmonics: where they lie comb_distances() tells
            longest = longest_comb_m(observations);
            return longest > parameter.low ? std::vector<double>{std::min(parameter.typical, longest)}
                                           : std::vector<double>{};
        }
        const double from = std::max(parameter.low, shortest), to = std::min(parameter.high, longest);
        return from < to ? grid(parameter, from, to, 2 + static_cast<int>(std::log(to / from) / kWavelengthStep))
                         : std::vector<double>{};
    }
    if (!parameter.strength) {
        if (effect.looked_for_over_ranges) return grid(parameter, parameter.low, parameter.high, kOtherPoints);
        return {parameter.typical};
    }
    if (is_one_of_several(effect, parameter))
        return {parameter.nothing, parameter.nothing + kMildShare * (parameter.high - parameter.nothing)};
    if (!std::isfinite(parameter.nothing) || parameter.nothing >= parameter.high)  // weak at the upper end
        return {parameter.spread == Spread::logarithmic
                    ? parameter.high * std::pow(parameter.low / parameter.high, kMildShare)
                    : parameter.high + kMildShare * (parameter.low - parameter.high)};
    const double weak = std::max(parameter.low, std::min(parameter.nothing, parameter.high));
    return {parameter.spread == Spread::logarithmic ? weak * std::pow(parameter.high / weak, kMildShare)
                                                    : weak + kMildShare * (parameter.high - weak)};
}

std::vector<std::string> channel_options(const EffectChoice& choice, const std::vector<Observation>& observations) {
    std::vector<std::string> kept;
    for (const std::string& option : choice.options)
        for (const Observation& observation : observations) {
            const std::string where = pem::measured_response(option);
            const bool there = std::any_of(
                observation.channels.begin(), observation.channels.end(),
                [&](const ObservedChannel& channel) { return pem::response_names()[channel.response].where == where; });
            if (there && std::find(kept.begin(), kept.end(), option) == kept.end()) kept.push_back(option);
        }
    return kept;
}

/// Orders of a wheel whose line lies in the band of a recording.
std::vector<std::string> order_options(const EffectChoice& choice, const Trial& trial,
                                       const std::vector<Observation>& observations) {
    std::vector<std::string> kept;
    for (const std::string& option : choice.options)
        for (const Observation& observation : observations) {
            const double line = std::stod(option) * observation.speed_m_per_s /
                                (2.0 * std::numbers::pi * trial.numbers.vehicle.wheel_radius_m);
            if (line < observation.expectation.low_hz || line > observation.expectation.high_hz) continue;
            kept.push_back(option);
            break;
        }
    return kept;
}

std::vector<std::string> options_of(const EffectChoice& choice, const Trial& trial,
                                    const std::vector<Observation>& observations) {
    if (choice.name == "channel") return channel_options(choice, observations);
    if (choice.name == "order") return order_options(choice, trial, observations);
    if (choice.name == "every") return {"2", "3", "4", "5", "6", "8", "10", "12", "16", "20"};
    return choice.options;
}

/// "receptance and decay rate".
std::string kinds_in_words(const std::vector<Observation>& observations) {
    std::set<std::string> kinds;
    for (const Observation& observation : observations) kinds.insert(kind_in_words(observation));
    return fmt::format("{}", fmt::join(kinds, " and "));
}

void add_choices(const Effect& effect, std::size_t index, const EffectInstance& so_far, const Trial& trial,
                 const std::vector<Observation>& observations, std::vector<EffectInstance>& variants) {
    if (index == effect.choices.size()) {
        variants.push_back(so_far);
        return;
    }
    const EffectChoice& choice = effect.choices[index];
    if (!choice.required) add_choices(effect, index + 1, so_far, trial, observations, variants);
    for (const std::string& option : options_of(choice, trial, observations)) {
        EffectInstance with = so_far;
        with.choices[choice.name] = option;
        add_choices(effect, index + 1, with, trial, observations, variants);
    }
}

void add_values(const Effect& effect, std::size_t index, const EffectInstance& so_far,
                const std::vector<Observation>& observations, std::vector<EffectInstance>& variants) {
    if (index == effect.parameters.size()) {
        variants.push_back(so_far);
        return;
    }
    const EffectParameter& parameter = effect.parameters[index];
    const bool replaced = std::any_of(effect.choices.begin(), effect.choices.end(), [&](const EffectChoice& choice) {
        return choice.replaces == parameter.name && so_far.choices.count(choice.name) > 0;
    });
    if (replaced) return add_values(effect, index + 1, so_far, observations, variants);
    for (const double value : looking_points(effect, parameter, observations)) {
        EffectInstance with = so_far;
        with.values[parameter.name] = value;
        add_values(effect, index + 1, with, observations, variants);
    }
}

/// Several strengths, and none of them there.
bool is_nothing_at_all(const Effect& effect, const EffectInstance& instance) {
    int there = 0, nothing = 0;
    for (const EffectParameter& parameter : effect.parameters)
        if (parameter.strength) ++(is_at_nothing(parameter, instance) ? nothing : there);
    return nothing > 0 && there == 0;
}

constexpr double kProbe = 1e-6;  ///< of the range: second order stays below the noise

/// A strength on the other side of zero (an inverted channel): no derivative leads there.
bool is_inverted(const Effect& effect, const EffectInstance& instance) {
    return std::any_of(effect.parameters.begin(), effect.parameters.end(), [&](const EffectParameter& parameter) {
        return parameter.strength && std::isfinite(parameter.nothing) && instance.values.count(parameter.name) &&
               instance.values.at(parameter.name) * parameter.nothing < 0.0;
    });
}

/// Whether screening looks where the instance stands, because its first derivative at nothing says nothing.
bool is_probed_at_strength(const Effect& effect, const EffectInstance& instance) {
    const bool is_source = std::any_of(effect.parameters.begin(), effect.parameters.end(),
                                       [](const EffectParameter& parameter) { return parameter.amplitude; });
    return effect.replaces || effect.abrupt || is_source || is_inverted(effect, instance);
}

/// A strength `steps` probes away from nothing.
double near_nothing(const EffectParameter& parameter, double steps) {
    if (!std::isfinite(parameter.nothing)) return parameter.high / (kProbe * steps);
    const double towards =
        parameter.nothing >= parameter.high ? parameter.low - parameter.nothing : parameter.high - parameter.nothing;
    return parameter.nothing + kProbe * steps * towards;
}

EffectInstance probe_of(const Effect& effect, EffectInstance instance) {
    if (is_probed_at_strength(effect, instance)) return instance;
    for (const EffectParameter& parameter : effect.parameters)
        if (parameter.strength && instance.values.count(parameter.name) && !is_at_nothing(parameter, instance))
            instance.values[parameter.name] = near_nothing(parameter, 1.0);
    return instance;
}

/// What is probed where it stands and adds no power of its own has no smaller beginning.
bool is_whole(const Effect& effect, const EffectInstance& instance) {
    return is_probed_at_strength(effect, instance) &&
           std::none_of(effect.parameters.begin(), effect.parameters.end(),
                        [](const EffectParameter& parameter) { return parameter.amplitude; });
}

/// Nothing lies inside the range of a strength: it may go either way.
bool is_two_sided(const Effect& effect) {
    return std::any_of(effect.parameters.begin(), effect.parameters.end(), [](const EffectParameter& parameter) {
        return parameter.strength && parameter.nothing > parameter.low && parameter.nothing < parameter.high;
    });
}

}  // namespace

CandidateList candidates(const BelievedCase& believed, const Trial& trial,
                         const std::vector<Observation>& observations) {
    CandidateList list;
    const pem::CaseParameters parameters = case_of(trial, believed, observations.front());
    for (const Effect& effect : effects()) {
        if (effect.wrong_number) continue;
        if (std::none_of(observations.begin(), observations.end(),
                         [&](const Observation& own) { return could_show(own, effect); })) {
            list.not_tested.push_back({effect.id, "it cannot show in " + kinds_in_words(observations)});
            continue;
        }
        if (effect.obstacle)
            if (const auto obstacle = effect.obstacle(parameters)) {
                list.not_tested.push_back({effect.id, obstacle->problem});
                continue;
            }
        std::vector<EffectInstance> chosen, variants;
        add_choices(effect, 0, {.effect = effect.id}, trial, observations, chosen);
        for (const EffectInstance& instance : chosen) add_values(effect, 0, instance, observations, variants);
        std::erase_if(variants, [&](const EffectInstance& instance) { return is_nothing_at_all(effect, instance); });
        if (variants.empty())
            list.not_tested.push_back({effect.id, "it would show in no band or channel of the recordings"});
        std::set<std::map<std::string, std::string>> places;
        for (const EffectInstance& instance : variants) places.insert(instance.choices);
        for (EffectInstance& instance : variants)
            list.candidates.push_back({.instance = instance,
                                       .probe = probe_of(effect, instance),
                                       .two_sided = is_two_sided(effect) && !is_whole(effect, instance),
                                       .whole = is_whole(effect, instance),
                                       .log_prior = -std::log(static_cast<double>(effects().size() * places.size()))});
    }
    return list;
}

Candidate started_at(const Candidate& candidate, double strength) {
    Candidate started = candidate;
    const Effect& effect = *find_effect(candidate.instance.effect);
    const bool at_strength = candidate.whole || is_probed_at_strength(effect, candidate.instance);
    for (const EffectParameter& parameter : effect.parameters) {
        if (!parameter.strength || !candidate.instance.values.count(parameter.name) ||
            is_at_nothing(parameter, candidate.instance))
            continue;
        double& value = started.instance.values[parameter.name];
        if (at_strength && parameter.amplitude && strength > 0.0)
            value = std::clamp(parameter.nothing + (value - parameter.nothing) * std::sqrt(strength), parameter.low,
                               parameter.high);
        if (!at_strength && std::abs(strength) > 1.0)
            value = std::clamp(near_nothing(parameter, strength), parameter.low, parameter.high);
    }
    return started;
}

bool same_variant(const EffectInstance& first, const EffectInstance& second) {
    return first.effect == second.effect && first.choices == second.choices;
}

std::string label_of(const EffectInstance& instance) {
    std::string text;
    for (const auto& [name, value] : instance.choices) text += (text.empty() ? "" : ", ") + name + " " + value;
    return text.empty() ? instance.effect : fmt::format("{} ({})", instance.effect, text);
}

}  // namespace railpem::diagnosis
