#include <limits>

#include "effects/catalogue.hpp"

namespace railpem::effects {

EffectDescription secondary_bump_stop() {
    return {
        .id = "secondary-bump-stop",
        .row = 310,
        .says = "bump stops close beside the secondary springs",
        .parameters = {{.name = "stiffness_n_per_m",
                        .unit = "N/m",
                        .low = 1e5,
                        .high = 5e7,
                        .typical = 5e6,
                        .says = "of the stop"},
                       {.name = "gap_m",
                        .unit = "m",
                        .low = 1e-4,
                        .high = 0.03,
                        .typical = 0.002,
                        .strength = true,
                        .nothing = std::numeric_limits<double>::infinity(),
                        .says = "free travel either way"}},
        .elements = {Element::secondary},
        .only_simulated = true,
        .draws = {{.parameters =
                       {{.name = "stiffness_n_per_m", .low = 1e6, .high = 3e7, .spacing = DrawSpacing::logarithmic},
                        {.name = "gap_m", .low = 2e-4, .high = 5e-3, .spacing = DrawSpacing::logarithmic}},
                   .strength = "gap_m"}},
    };
}

}  // namespace railpem::effects
