#include "parameters/parameter_error.hpp"
#include "simulate/effects/hidden_effects.hpp"

namespace railpem::simulate {

void hide_suspension_friction(const HiddenValues& values, HiddenTarget target) {
    const std::string& stage = values.texts.at("stage");
    if (stage != "primary" && stage != "secondary")
        throw parameters::ParameterError("--hide suspension-friction:stage", "no stage \"" + stage + "\"",
                                         "primary, secondary");
    (stage == "primary" ? target.parameters.vehicle.primary : target.parameters.vehicle.secondary).friction_force_n +=
        values.numbers.at("force_n");
}

}  // namespace railpem::simulate
