#include "simulate/effects/hidden_effects.hpp"

namespace railpem::simulate {

void hide_sleeper_passing(const HiddenValues& values, HiddenTarget target) {
    target.parameters.sleeper_passing.amplitude_factor = values.numbers.at("amplitude_factor");
}

}  // namespace railpem::simulate
