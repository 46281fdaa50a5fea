#include <algorithm>

#include "diagnosis/effects/effect.hpp"
#include "effects/catalogue.hpp"

namespace railpem::diagnosis {

const std::vector<Effect>& effects() {
    static const std::vector<Effect> library = [] {
        const std::map<std::string, EffectInModel> in_model = effects_in_model();
        std::vector<Effect> all;
        for (const effects::EffectDescription& effect : effects::catalogue())
            if (!effect.only_simulated) all.push_back({effect, in_model.at(effect.id)});
        return all;
    }();
    return library;
}

const Effect* find_effect(const std::string& id) {
    const auto found =
        std::find_if(effects().begin(), effects().end(), [&](const Effect& effect) { return effect.id == id; });
    return found == effects().end() ? nullptr : &*found;
}

EffectInstance wrong_number(const std::string& key, double factor) {
    return {.effect = effects::wrong_number_id(), .values = {{"factor", factor}}, .choices = {{"parameter", key}}};
}

EffectInstance wrong_gain(const std::string& channel, double gain) {
    const auto scales_a_channel = [](const Effect& effect) {
        return std::any_of(effect.parameters.begin(), effect.parameters.end(),
                           [](const EffectParameter& own) { return own.name == "gain"; });
    };
    const std::string& id = std::find_if(effects().begin(), effects().end(), scales_a_channel)->id;
    return {.effect = id, .values = {{"gain", gain}}, .choices = {{"channel", channel}}};
}

bool is_wrong_number(const EffectInstance& instance) {
    return instance.effect == effects::wrong_number_id();
}

}  // namespace railpem::diagnosis
