#include "diagnosis/hypotheses/proposers/comb_relatives.hpp"

#include <algorithm>

namespace railpem::diagnosis {

double longest_comb_m(const std::vector<Observation>& observations) {
    constexpr double kBinsApart = 1.5;  // a Hann window's lobe is 1.44 bins wide at half its power
    double longest = std::numeric_limits<double>::infinity();
    bool any = false;
    for (const Observation& observation : observations) {
        if (observation.scalar) continue;
        any = true;
        longest = std::min(longest, observation.speed_m_per_s / (kBinsApart * observation.kernel.bin_hz()));
    }
    return any ? longest : 0.0;
}

namespace {

/// The distance of a comb of lines among the parameters of an effect, where the instance states one; null otherwise.
const EffectParameter* comb_of(const EffectInstance& instance) {
    const Effect& effect = *find_effect(instance.effect);
    const auto comb = std::find_if(effect.parameters.begin(), effect.parameters.end(),
                                   [](const EffectParameter& parameter) { return parameter.comb; });
    return comb == effect.parameters.end() || !instance.values.count(comb->name) ? nullptr : &*comb;
}

}  // namespace

std::vector<EffectInstance> comb_decoys(const EffectInstance& fitted) {
    // from the fourteenth line on by more than half of their distance, of which no multiple is another's
    constexpr double kAside = 1.037;
    const EffectParameter* comb = comb_of(fitted);
    std::vector<EffectInstance> decoys;
    if (!comb) return decoys;
    for (const double ratio : {kAside, 1.0 / kAside}) {
        const double distance = ratio * fitted.values.at(comb->name);
        if (distance < comb->low || distance > comb->high) continue;
        decoys.push_back(fitted);
        decoys.back().values[comb->name] = distance;
    }
    return decoys;
}

std::vector<EffectInstance> comb_relatives(const EffectInstance& fitted, double longest_m) {
    constexpr double kRatios[] = {1.0 / 2.0, 1.0 / 3.0, 1.0 / 4.0, 1.0 / 5.0, 2.0, 3.0};
    const Effect& effect = *find_effect(fitted.effect);
    const EffectParameter* comb = comb_of(fitted);
    std::vector<EffectInstance> relatives;
    if (!comb) return relatives;
    for (const double ratio : kRatios) {
        const double distance = ratio * fitted.values.at(comb->name);
        if (distance < comb->low || distance > std::min(comb->high, longest_m)) continue;
        EffectInstance relative = fitted;
        relative.values[comb->name] = distance;
        for (const EffectParameter& parameter : effect.parameters)
            if (parameter.strength)
                relative.values[parameter.name] =
                    std::clamp(ratio * fitted.values.at(parameter.name), parameter.low, parameter.high);
        relatives.push_back(std::move(relative));
    }
    return relatives;
}

}  // namespace railpem::diagnosis
