#include "simulate/effects/hidden_effects.hpp"

namespace railpem::simulate {

void hide_rail_corrugation(const HiddenValues& values, HiddenTarget target) {
    target.parameters.irregularity.corrugation.push_back(
        {values.numbers.at("wavelength_m"), values.numbers.at("relative_bandwidth"), values.numbers.at("rms_m")});
}

}  // namespace railpem::simulate
