#include <limits>

#include "effects/catalogue.hpp"

namespace railpem::effects {

EffectDescription secondary_damper_series_stiffness() {
    return {
        .id = "secondary-damper-series-stiffness",
        .row = 180,
        .says =
            "the damper of the secondary suspension acts through a spring (its bushings, or rubber): fast movements "
            "bypass it",
        .in_short = "the secondary damper acts through a spring",
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
                        .simulated = {.standard = 3e6},
                        .in_short = "in series with the damper",
                        .says = "spring in series with the damper of one element, per rail side"}},
        .elements = {Element::secondary},
        .bands = {{1.0, 100.0}},
        .mimics =
            "A weaker secondary damper (parameter-error of vehicle.secondary.damping_n_s_per_m) at the body's bounce; "
            "above it the body is isolated far better, ratio body to bogie falling with 1/f² instead of 1/f. "
            "Friction changes with the level of the track, this does not.",
        .draws = {{.parameters =
                       {{.name = "stiffness_n_per_m", .low = 1e6, .high = 6e7, .spacing = DrawSpacing::logarithmic}},
                   .strength = "stiffness_n_per_m"}},
    };
}

}  // namespace railpem::effects
