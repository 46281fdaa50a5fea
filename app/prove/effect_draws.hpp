#pragma once
// The draws of the catalogue, by the kinds of trials that take them.

#include <string>
#include <vector>

#include "effects/effect_description.hpp"

namespace railpem::app {

using effects::DrawMirror;
using effects::DrawnParameter;
using effects::DrawSpacing;

/// One way to draw an effect, and how it fades.
struct EffectDraw : effects::EffectDraw {
    std::string id;
    bool weak_when_large = false;  ///< it fades as its strength grows
    double nothing = 0.0;          ///< value at which it has faded (0 where it fades towards infinity)
};

/// Physics of the catalogue. Effects that the case forbids are taken out by drawable_effects().
const std::vector<EffectDraw>& physics_draws();

/// Sensor faults of the catalogue.
const std::vector<EffectDraw>& sensor_draws();

/// A believed value that is wrong beyond its tolerance; the trial adds the key.
const EffectDraw& parameter_error_draw();

/// Effects that the simulator has and the diagnosis has not.
const std::vector<EffectDraw>& outside_draws();

/// The first draw of that effect in any of the lists, or null.
const EffectDraw* find_draw(const std::string& id);

}  // namespace railpem::app
