#include "simulate/effects/hidden_effects.hpp"

namespace railpem::simulate {

void hide_body_bending(const HiddenValues& values, HiddenTarget target) {
    target.parameters.vehicle.body_bending = {{values.numbers.at("frequency_hz"), values.numbers.at("damping_ratio"),
                                               values.numbers.at("modal_mass_kg"),
                                               values.numbers.at("shape_at_pivots")}};
}

}  // namespace railpem::simulate
