#include "simulate/effects/hidden_effects.hpp"

namespace railpem::simulate {

void hide_pad_hysteresis(const HiddenValues& values, HiddenTarget target) {
    target.parameters.track.pads.loss_factor = values.numbers.at("loss_factor");
    target.parameters.track.pads.loss_law = track::LossLaw::causal;
}

}  // namespace railpem::simulate
