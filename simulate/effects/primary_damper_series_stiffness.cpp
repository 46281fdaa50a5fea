#include "simulate/effects/hidden_effects.hpp"

namespace railpem::simulate {

void hide_primary_damper_series_stiffness(const HiddenValues& values, HiddenTarget target) {
    target.parameters.vehicle.primary.damper_series_stiffness_n_per_m = values.numbers.at("stiffness_n_per_m");
}

}  // namespace railpem::simulate
