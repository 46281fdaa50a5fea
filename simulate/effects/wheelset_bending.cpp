#include "simulate/effects/hidden_effects.hpp"

namespace railpem::simulate {

void hide_wheelset_bending(const HiddenValues& values, HiddenTarget target) {
    target.parameters.vehicle.wheelset_bending = {
        {values.numbers.at("frequency_hz"), values.numbers.at("damping_ratio"), values.numbers.at("modal_mass_kg")}};
}

}  // namespace railpem::simulate
