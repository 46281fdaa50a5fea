#include "simulate/effects/hidden_effects.hpp"

namespace railpem::simulate {

void hide_bogie_mounted_mass(const HiddenValues& values, HiddenTarget target) {
    target.parameters.vehicle.bogie_mounted_masses.push_back(
        {values.numbers.at("mass_kg"), values.numbers.at("frequency_hz"), values.numbers.at("damping_ratio"),
         values.numbers.at("position_m")});
}

}  // namespace railpem::simulate
