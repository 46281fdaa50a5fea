#include "effects/catalogue.hpp"

namespace railpem::effects {

EffectDescription guidance_stick_slip() {
    return {
        .id = "guidance-stick-slip",
        .row = 290,
        .says = "the guidance of the axle boxes sticks harder than it slides",
        .parameters = {{.name = "force_n",
                        .unit = "N",
                        .low = 100.0,
                        .high = 10000.0,
                        .typical = 1500.0,
                        .strength = true,
                        .says = "sliding force per axle box"},
                       {.name = "static_to_kinetic",
                        .unit = "1",
                        .low = 1.1,
                        .high = 3.0,
                        .typical = 1.6,
                        .says = "sticking over sliding force"},
                       {.name = "stribeck_velocity_m_per_s",
                        .unit = "m/s",
                        .low = 0.002,
                        .high = 0.1,
                        .typical = 0.01,
                        .says = "over which it falls"}},
        .elements = {Element::primary},
        .only_simulated = true,
        .draws =
            {{.parameters = {{.name = "force_n", .low = 300.0, .high = 8000.0, .spacing = DrawSpacing::logarithmic},
                             {.name = "static_to_kinetic", .low = 1.2, .high = 2.5},
                             {.name = "stribeck_velocity_m_per_s",
                              .low = 0.005,
                              .high = 0.05,
                              .spacing = DrawSpacing::logarithmic}},
              .strength = "force_n"}},
    };
}

}  // namespace railpem::effects
