#include "effects/catalogue.hpp"

namespace railpem::effects {

EffectDescription pad_dead_band() {
    return {
        .id = "pad-dead-band",
        .row = 320,
        .says = "the fastening has play: beyond some load the pad gives before it stiffens again",
        .parameters = {{.name = "gap_m",
                        .unit = "m",
                        .low = 2e-5,
                        .high = 2e-3,
                        .typical = 3e-4,
                        .strength = true,
                        .says = "of the play"},
                       {.name = "at_load_n",
                        .unit = "N",
                        .low = 0.0,
                        .high = 8e4,
                        .typical = 2e4,
                        .says = "load of the pad at which it begins"}},
        .elements = {Element::pad},
        .only_simulated = true,
        .draws = {{.parameters = {{.name = "gap_m", .low = 5e-5, .high = 1e-3, .spacing = DrawSpacing::logarithmic},
                                  {.name = "at_load_n", .low = 1e4, .high = 4e4}},
                   .strength = "gap_m"}},
    };
}

}  // namespace railpem::effects
