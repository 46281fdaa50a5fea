#include "effects/catalogue.hpp"

#include <algorithm>
#include <stdexcept>

namespace railpem::effects {

const std::vector<EffectDescription>& catalogue() {
    static const std::vector<EffectDescription> all = [] {
        std::vector<EffectDescription> effects = described_effects();
        std::sort(effects.begin(), effects.end(),
                  [](const EffectDescription& a, const EffectDescription& b) { return a.row < b.row; });
        for (std::size_t i = 1; i < effects.size(); ++i)
            if (effects[i].row == effects[i - 1].row)
                throw std::logic_error(effects[i].id + " and " + effects[i - 1].id + " have the same row");
        return effects;
    }();
    return all;
}

const EffectDescription* find_description(const std::string& id) {
    const auto found = std::find_if(catalogue().begin(), catalogue().end(),
                                    [&](const EffectDescription& effect) { return effect.id == id; });
    return found == catalogue().end() ? nullptr : &*found;
}

const std::string& wrong_number_id() {
    static const std::string& id = std::find_if(catalogue().begin(), catalogue().end(), [](const auto& effect) {
                                       return effect.wrong_number;
                                   })->id;
    return id;
}

}  // namespace railpem::effects
