#include "simulate/effects/hidden_effects.hpp"

namespace railpem::simulate {

void hide_pad_frequency_stiffening(const HiddenValues& values, HiddenTarget target) {
    target.parameters.track.pads.exponent = values.numbers.at("exponent");
    target.parameters.track.pads.causal = true;
}

}  // namespace railpem::simulate
