#include "simulate/effects/hidden_effects.hpp"

namespace railpem::simulate {

void hide_bogie_coupling(const HiddenValues& values, HiddenTarget target) {
    target.only_here.bogie_coupling = {values.numbers.at("stiffness_n_per_m"), values.numbers.at("damping_n_s_per_m"),
                                       values.numbers.at("arm_m")};
}

}  // namespace railpem::simulate
