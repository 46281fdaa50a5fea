#include "simulate/effects/hidden_effects.hpp"

namespace railpem::simulate {

void hide_wandering_subgrade(const HiddenValues& values, HiddenTarget target) {
    target.only_here.wandering_subgrade = {values.numbers.at("mass_kg"), values.numbers.at("frequency_hz"),
                                           values.numbers.at("damping_ratio"), values.numbers.at("variation"),
                                           values.numbers.at("length_m")};
}

}  // namespace railpem::simulate
