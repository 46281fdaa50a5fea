#include "simulate/effects/hidden_effects.hpp"

namespace railpem::simulate {

void hide_irregularity_spectrum(const HiddenValues& values, HiddenTarget target) {
    target.parameters.irregularity.level_db += values.numbers.at("level_db");
    target.parameters.irregularity.slope_db_per_octave += values.numbers.at("slope_db_per_octave");
}

}  // namespace railpem::simulate
