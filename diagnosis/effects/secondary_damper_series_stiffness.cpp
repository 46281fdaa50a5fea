#include "diagnosis/effects/catalogue.hpp"
#include "diagnosis/effects/damper_series_stiffness.hpp"

namespace railpem::diagnosis {

Effect secondary_damper_series_stiffness() {
    return damper_series_stiffness({
        .id = "secondary-damper-series-stiffness",
        .stage = "secondary",
        .suspension = &vehicle::VehicleParameters::secondary,
        .element = Element::secondary,
        .low_n_per_m = 2e5,
        .high_n_per_m = 1e8,
        .typical_n_per_m = 4e6,
        .band = {1.0, 100.0},
        .mimics =
            "A weaker secondary damper (parameter-error of vehicle.secondary.damping_n_s_per_m) at the body's bounce; "
            "above it the body is isolated far better, ratio body to bogie falling with 1/f² instead of 1/f. "
            "Friction changes with the level of the track, this does not.",
    });
}

}  // namespace railpem::diagnosis
