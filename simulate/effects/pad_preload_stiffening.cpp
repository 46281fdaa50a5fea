#include "simulate/effects/hidden_effects.hpp"

namespace railpem::simulate {

void hide_pad_preload_stiffening(const HiddenValues& values, HiddenTarget target) {
    target.parameters.track.pads.preload_strength = values.numbers.at("strength");
}

}  // namespace railpem::simulate
