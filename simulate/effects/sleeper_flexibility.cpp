#include "simulate/effects/hidden_effects.hpp"

namespace railpem::simulate {

void hide_sleeper_flexibility(const HiddenValues& values, HiddenTarget target) {
    target.parameters.track.support.bending_modes.push_back(
        {values.numbers.at("frequency_hz"), values.numbers.at("loss_factor"), values.numbers.at("modal_mass_kg")});
}

}  // namespace railpem::simulate
