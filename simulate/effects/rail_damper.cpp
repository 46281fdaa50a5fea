#include "simulate/effects/hidden_effects.hpp"

namespace railpem::simulate {

void hide_rail_damper(const HiddenValues& values, HiddenTarget target) {
    target.parameters.track.rail_dampers.push_back(
        // what is marched
        {values.numbers.at("mass_kg_per_m"), values.numbers.at("frequency_hz"), values.numbers.at("loss_factor"), 1.0});
}

}  // namespace railpem::simulate
