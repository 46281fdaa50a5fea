#include "effects/catalogue.hpp"

namespace railpem::effects {

EffectDescription wandering_subgrade() {
    return {
        .id = "wandering-subgrade",
        .row = 330,
        .says = "the ground resonates at a frequency that wanders along the line",
        .parameters =
            {{.name = "mass_kg", .unit = "kg", .low = 50.0, .high = 5000.0, .typical = 800.0, .says = "per seat"},
             {.name = "frequency_hz", .unit = "Hz", .low = 10.0, .high = 120.0, .typical = 35.0, .says = "mean"},
             {.name = "damping_ratio", .unit = "1", .low = 0.02, .high = 0.6, .typical = 0.1, .says = "of the ground"},
             {.name = "variation",
              .unit = "1",
              .low = 0.0,
              .high = 0.6,
              .typical = 0.25,
              .says = "relative amplitude of the wandering"},
             {.name = "length_m",
              .unit = "m",
              .low = 20.0,
              .high = 2000.0,
              .typical = 150.0,
              .says = "of one wave of it"}},
        .elements = {Element::support},
        .only_simulated = true,
        .draws =
            {{.parameters = {{.name = "mass_kg", .low = 200.0, .high = 3000.0, .spacing = DrawSpacing::logarithmic},
                             {.name = "frequency_hz", .low = 20.0, .high = 80.0, .spacing = DrawSpacing::logarithmic},
                             {.name = "damping_ratio", .low = 0.05, .high = 0.3, .spacing = DrawSpacing::logarithmic},
                             {.name = "variation", .low = 0.1, .high = 0.4},
                             {.name = "length_m", .low = 50.0, .high = 500.0, .spacing = DrawSpacing::logarithmic}}}},
    };
}

}  // namespace railpem::effects
