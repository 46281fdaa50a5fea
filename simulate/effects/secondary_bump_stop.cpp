#include "simulate/effects/hidden_effects.hpp"

namespace railpem::simulate {

void hide_secondary_bump_stop(const HiddenValues& values, HiddenTarget target) {
    target.only_here.secondary_bump_stop = {values.numbers.at("stiffness_n_per_m"), values.numbers.at("gap_m")};
}

}  // namespace railpem::simulate
