#pragma once
// Effects of typical strength in recordings of nine channels: what the programs of docs/proof hide.

#include <algorithm>
#include <vector>

#include "diagnosis/fit/synthesis.hpp"
#include "diagnosis/hypotheses/candidates.hpp"

namespace railpem::tests {

/// Nine channels of a case at some speeds, without data.
inline std::vector<diagnosis::Observation> nine_channel_shapes(const diagnosis::BelievedCase& believed,
                                                               const std::vector<double>& speeds_m_per_s,
                                                               double seconds) {
    const std::vector<std::string> channels = {"body_front", "body",    "body_rear", "bogie_1", "bogie_2",
                                               "wheel_1",    "wheel_2", "wheel_3",   "wheel_4"};
    std::vector<diagnosis::Observation> shapes;
    for (const double speed : speeds_m_per_s) {
        shapes.push_back(diagnosis::observation_shape(speed, 0.0, seconds, channels, believed.numbers, {}));
        shapes.back().name = std::to_string(speed);
    }
    return shapes;
}

/// Typical instances of every effect that the case allows; of those that sit in several places the first wheel or
/// channel.
inline std::vector<diagnosis::Candidate> typical_effects(const diagnosis::BelievedCase& believed,
                                                         const std::vector<diagnosis::Observation>& observations) {
    std::vector<diagnosis::Candidate> first;
    for (const diagnosis::Candidate& candidate :
         diagnosis::candidates(believed, diagnosis::believed_trial(believed, observations), observations).candidates) {
        const auto& choices = candidate.instance.choices;
        if (choices.count("wheel") && (choices.at("wheel") != "2" || choices.at("order") != "3")) continue;
        if (choices.count("channel") && choices.at("channel") != "bogie_1") continue;
        if (std::any_of(first.begin(), first.end(), [&](const diagnosis::Candidate& own) {
                return diagnosis::same_variant(own.instance, candidate.instance);
            }))
            continue;
        first.push_back(candidate);
        for (const diagnosis::EffectParameter& parameter :
             diagnosis::find_effect(candidate.instance.effect)->parameters)
            if (first.back().instance.values.count(parameter.name))
                first.back().instance.values[parameter.name] = parameter.typical;
        // Typical of dampers against rolling noise: above what is recorded here.
        if (candidate.instance.effect == "rail-damper") first.back().instance.values["frequency_hz"] = 120.0;
    }
    return first;
}

}  // namespace railpem::tests
