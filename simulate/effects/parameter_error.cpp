#include "parameters/parameter_error.hpp"
#include "simulate/effects/hidden_effects.hpp"

namespace railpem::simulate {

void hide_parameter_error(const HiddenValues& values, HiddenTarget target) {
    if (!target.scale)
        throw parameters::ParameterError("--hide parameter-error", "the keys of the case are not known here",
                                         "another effect");
    target.scale(target.parameters, values.texts.at("parameter"), values.numbers.at("factor"));
}

}  // namespace railpem::simulate
