#include "simulate/effects/hidden_effects.hpp"

namespace railpem::simulate {

void hide_pad_dead_band(const HiddenValues& values, HiddenTarget target) {
    target.only_here.pad_dead_band = {values.numbers.at("gap_m"), values.numbers.at("at_load_n")};
}

}  // namespace railpem::simulate
