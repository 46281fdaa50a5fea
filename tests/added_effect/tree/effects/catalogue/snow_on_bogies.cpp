#include "effects/catalogue.hpp"

namespace railpem::effects {

EffectDescription snow_on_bogies() {
    return {
        .id = "snow-on-bogies",
        .row = 165,
        .says = "snow and ice cling to the bogie frames and make them heavier",
        .in_short = "snow and ice cling to the bogie frames",
        .equation = "bogie mass + m",
        .source = "made up, to try how an effect is added",
        .parameters = {{.name = "snow_kg",
                        .unit = "kg",
                        .low = 20.0,
                        .high = 900.0,
                        .typical = 300.0,
                        .spread = Spread::logarithmic,
                        .strength = true,
                        .nothing = 0.0,
                        .says = "mass on each bogie"}},
        .elements = {Element::bogie},
        .bands = {{1.0, 60.0}},
        .mimics = "A heavier bogie, which it is; it melts.",
        .draws = {{.parameters = {{.name = "snow_kg", .low = 50.0, .high = 800.0, .spacing = DrawSpacing::logarithmic}},
                   .strength = "snow_kg"}},
    };
}

}  // namespace railpem::effects
