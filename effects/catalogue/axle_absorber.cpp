#include "effects/catalogue.hpp"

namespace railpem::effects {

EffectDescription axle_absorber() {
    return {
        .id = "axle-absorber",
        .row = 280,
        .says = "a tuned absorber sits on the axles",
        .parameters = {{.name = "mass_kg",
                        .unit = "kg",
                        .low = 10.0,
                        .high = 300.0,
                        .typical = 80.0,
                        .strength = true,
                        .says = "per wheelset"},
                       {.name = "frequency_hz",
                        .unit = "Hz",
                        .low = 15.0,
                        .high = 150.0,
                        .typical = 45.0,
                        .says = "on a fixed axle"},
                       {.name = "damping_ratio",
                        .unit = "1",
                        .low = 0.01,
                        .high = 0.5,
                        .typical = 0.08,
                        .says = "of the absorber"},
                       {.name = "wheel",
                        .unit = "1",
                        .low = 0.0,
                        .high = 4.0,
                        .typical = 0.0,
                        .says = "1 to 4; 0: on every axle"}},
        .elements = {Element::wheel},
        .only_simulated = true,
        .draws =
            {{.parameters = {{.name = "mass_kg", .low = 20.0, .high = 300.0, .spacing = DrawSpacing::logarithmic},
                             {.name = "frequency_hz", .low = 20.0, .high = 120.0, .spacing = DrawSpacing::logarithmic},
                             {.name = "damping_ratio", .low = 0.02, .high = 0.3, .spacing = DrawSpacing::logarithmic},
                             {.name = "wheel", .low = 0.0, .high = 4.0, .spacing = DrawSpacing::whole}},
              .strength = "mass_kg"}},
    };
}

}  // namespace railpem::effects
