#include "simulate/effects/hidden_effects.hpp"

namespace railpem::simulate {

void hide_axle_absorber(const HiddenValues& values, HiddenTarget target) {
    target.only_here.axle_absorber = {values.numbers.at("mass_kg"), values.numbers.at("frequency_hz"),
                                      values.numbers.at("damping_ratio"), static_cast<int>(values.numbers.at("wheel"))};
}

}  // namespace railpem::simulate
