#include "parameters/parameter_error.hpp"
#include "simulate/effects/hidden_effects.hpp"

namespace railpem::simulate {

void hide_failed_fasteners(const HiddenValues& values, HiddenTarget target) {
    track::FailedFasteners failed;
    failed.every = static_cast<int>(values.numbers.at("every"));
    failed.fraction = values.numbers.at("fraction");
    if (failed.every == 0 && failed.fraction == 0.0)
        throw parameters::ParameterError("--hide failed-fasteners", "neither every nor fraction is given",
                                         "every=N or fraction=SHARE");
    failed.remaining_stiffness_fraction = values.numbers.at("remaining_stiffness_fraction");
    failed.seed = static_cast<int>(values.numbers.at("seed"));
    target.parameters.track.failed_fasteners = {failed};
}

}  // namespace railpem::simulate
