#include "simulate/effects/hidden_effects.hpp"

namespace railpem::simulate {

void hide_rail_shear(const HiddenValues& values, HiddenTarget target) {
    target.parameters.track.rail.beam = track::Beam::timoshenko;
    target.parameters.track.rail.shear_coefficient = values.numbers.at("shear_coefficient");
}

}  // namespace railpem::simulate
