#include "simulate/effects/hidden_effects.hpp"

namespace railpem::simulate {

void hide_contact_filter(const HiddenValues& values, HiddenTarget target) {
    target.parameters.contact.patch_half_length_m = values.numbers.at("patch_half_length_m");
}

}  // namespace railpem::simulate
