#include "simulate/effects/hidden_effects.hpp"

namespace railpem::simulate {

void hide_contact_nonlinearity(const HiddenValues& values, HiddenTarget target) {
    target.parameters.contact.nonlinearity_factor = values.numbers.at("factor");
}

}  // namespace railpem::simulate
