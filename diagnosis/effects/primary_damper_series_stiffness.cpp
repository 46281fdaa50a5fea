#include "diagnosis/effects/catalogue.hpp"
#include "diagnosis/effects/damper_series_stiffness.hpp"

namespace railpem::diagnosis {

Effect primary_damper_series_stiffness() {
    return damper_series_stiffness({
        .id = "primary-damper-series-stiffness",
        .stage = "primary",
        .suspension = &vehicle::VehicleParameters::primary,
        .element = Element::primary,
        .low_n_per_m = 2e5,
        .high_n_per_m = 5e7,
        .typical_n_per_m = 4e6,
        .band = {5.0, 100.0},
        .mimics =
            "A weaker primary damper (parameter-error of vehicle.primary.damping_n_s_per_m) at the bogie's bounce; "
            "above c/k_s the Maxwell element becomes a spring and the ratio bogie to axle box falls faster. Friction "
            "changes with the level of the track, this does not.",
    });
}

}  // namespace railpem::diagnosis
