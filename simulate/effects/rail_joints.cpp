#include "simulate/effects/hidden_effects.hpp"

namespace railpem::simulate {

void hide_rail_joints(const HiddenValues& values, HiddenTarget target) {
    target.parameters.irregularity.joints.push_back(
        {values.numbers.at("spacing_m"), values.numbers.at("depth_m"), values.numbers.at("length_m")});
}

}  // namespace railpem::simulate
