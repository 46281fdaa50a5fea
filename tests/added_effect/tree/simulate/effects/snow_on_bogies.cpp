#include "simulate/effects/hidden_effects.hpp"

namespace railpem::simulate {

void hide_snow_on_bogies(const HiddenValues& values, HiddenTarget target) {
    target.parameters.vehicle.bogie_mass_kg += values.numbers.at("snow_kg");
}

}  // namespace railpem::simulate
