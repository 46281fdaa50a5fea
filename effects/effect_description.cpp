#include "effects/effect_description.hpp"

namespace railpem::effects {

std::string place_text(const EffectDescription& effect, const std::string& many) {
    if (effect.elements.size() > 2) return many;
    std::string text;
    for (const Element element : effect.elements) text += (text.empty() ? "" : " or ") + element_name(element);
    return text;
}

bool is_of_sensor(const EffectDescription& effect) {
    return effect.elements.size() == 1 && effect.elements.front() == Element::sensor;
}

}  // namespace railpem::effects
