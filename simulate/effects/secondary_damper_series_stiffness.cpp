#include "simulate/effects/hidden_effects.hpp"

namespace railpem::simulate {

void hide_secondary_damper_series_stiffness(const HiddenValues& values, HiddenTarget target) {
    target.parameters.vehicle.secondary.damper_series_stiffness_n_per_m = values.numbers.at("stiffness_n_per_m");
}

}  // namespace railpem::simulate
