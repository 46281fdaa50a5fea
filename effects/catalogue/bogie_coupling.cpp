#include "effects/catalogue.hpp"

namespace railpem::effects {

EffectDescription bogie_coupling() {
    return {
        .id = "bogie-coupling",
        .row = 270,
        .says = "a linkage under the car resists heave and pitch of the bogies against each other",
        .parameters = {{.name = "stiffness_n_per_m",
                        .unit = "N/m",
                        .low = 1e5,
                        .high = 2e7,
                        .typical = 2e6,
                        .strength = true,
                        .says = "of the linkage"},
                       {.name = "damping_n_s_per_m",
                        .unit = "N s/m",
                        .low = 0.0,
                        .high = 2e5,
                        .typical = 1e4,
                        .says = "of the linkage"},
                       {.name = "arm_m",
                        .unit = "m",
                        .low = 0.0,
                        .high = 5.0,
                        .typical = 1.5,
                        .says = "from the bogie centres inwards"}},
        .elements = {Element::bogie},
        .only_simulated = true,
        .draws = {{.parameters =
                       {{.name = "stiffness_n_per_m", .low = 5e5, .high = 2e7, .spacing = DrawSpacing::logarithmic},
                        {.name = "damping_n_s_per_m", .low = 1e3, .high = 1e5, .spacing = DrawSpacing::logarithmic},
                        {.name = "arm_m", .low = 0.0, .high = 3.0}},
                   .strength = "stiffness_n_per_m"}},
    };
}

}  // namespace railpem::effects
