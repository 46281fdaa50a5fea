#include <limits>

#include "effects/catalogue.hpp"

namespace railpem::effects {

EffectDescription primary_damper_series_stiffness() {
    return {
        .id = "primary-damper-series-stiffness",
        .row = 170,
        .says =
            "the damper of the primary suspension acts through a spring (its bushings, or rubber): fast movements "
            "bypass it",
        .in_short = "the primary damper acts through a spring",
        .equation =
            "Maxwell element: dynamic stiffness k + iωc·k_s/(iωc + k_s); in series with a spring the case has "
            "there already",
        .source = "Bruni, Vinolas, Berg, Polach & Stichel 2011, Vehicle System Dynamics 49",
        .parameters = {{.name = "stiffness_n_per_m",
                        .unit = "N/m",
                        .low = 1e5,
                        .high = 1e8,
                        .typical = 4e6,
                        .spread = Spread::logarithmic,
                        .strength = true,
                        .nothing = std::numeric_limits<double>::infinity(),
                        .simulated = {.standard = 5e6},
                        .in_short = "in series with the damper",
                        .says = "spring in series with the damper of one element, per rail side"}},
        .elements = {Element::primary},
        .bands = {{5.0, 100.0}},
        .mimics =
            "A weaker primary damper (parameter-error of vehicle.primary.damping_n_s_per_m) at the bogie's bounce; "
            "above c/k_s the Maxwell element becomes a spring and the ratio bogie to axle box falls faster. Friction "
            "changes with the level of the track, this does not.",
        .draws = {{.parameters =
                       {{.name = "stiffness_n_per_m", .low = 1e6, .high = 6e7, .spacing = DrawSpacing::logarithmic}},
                   .strength = "stiffness_n_per_m"}},
    };
}

}  // namespace railpem::effects
