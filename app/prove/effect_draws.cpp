#include "app/prove/effect_draws.hpp"

#include <cmath>

#include "effects/catalogue.hpp"

namespace railpem::app {

namespace {

using effects::EffectDescription;

EffectDraw draw_of(const EffectDescription& effect, const effects::EffectDraw& own) {
    EffectDraw draw{own, effect.id};
    for (const effects::EffectParameter& parameter : effect.parameters) {
        if (parameter.name != draw.strength) continue;
        draw.weak_when_large = std::isinf(parameter.nothing);
        draw.nothing = draw.weak_when_large ? 0.0 : parameter.nothing;
    }
    return draw;
}

template <typename Belongs>
std::vector<EffectDraw> draws_of(Belongs belongs) {
    std::vector<EffectDraw> draws;
    for (const EffectDescription& effect : effects::catalogue())
        if (belongs(effect))
            for (const effects::EffectDraw& own : effect.draws) draws.push_back(draw_of(effect, own));
    return draws;
}

}  // namespace

const std::vector<EffectDraw>& physics_draws() {
    static const std::vector<EffectDraw> all = draws_of([](const EffectDescription& effect) {
        return !is_of_sensor(effect) && !effect.wrong_number && !effect.only_simulated;
    });
    return all;
}

const std::vector<EffectDraw>& sensor_draws() {
    static const std::vector<EffectDraw> all =
        draws_of([](const EffectDescription& effect) { return is_of_sensor(effect) && !effect.only_simulated; });
    return all;
}

const EffectDraw& parameter_error_draw() {
    static const EffectDraw draw =
        draws_of([](const EffectDescription& effect) { return effect.wrong_number; }).front();
    return draw;
}

const std::vector<EffectDraw>& outside_draws() {
    static const std::vector<EffectDraw> all =
        draws_of([](const EffectDescription& effect) { return effect.only_simulated; });
    return all;
}

const EffectDraw* find_draw(const std::string& id) {
    for (const std::vector<EffectDraw>* list : {&physics_draws(), &sensor_draws(), &outside_draws()})
        for (const EffectDraw& draw : *list)
            if (draw.id == id) return &draw;
    return id == parameter_error_draw().id ? &parameter_error_draw() : nullptr;
}

}  // namespace railpem::app
