#include "effects/catalogue.hpp"

namespace railpem::effects {

EffectDescription rail_joints() {
    return {
        .id = "rail-joints",
        .row = 120,
        .says = "there are dips at a regular distance: joints or welds that have sunk",
        .in_short = "joints or dipped welds at a regular distance",
        .equation =
            "dips −h/2·(1 + cos(2πx/l)), |x| < l/2, every `spacing`: lines at n·v/spacing up to the order "
            "spacing/l and beyond; the same for all wheels",
        .source = "Wu & Thompson 2003, J. Sound Vib. 267 (dipped rail joints)",
        .parameters = {{.name = "spacing_m",
                        .unit = "m",
                        .low = 5.0,
                        .high = 120.0,
                        .typical = 25.0,
                        .spread = Spread::logarithmic,
                        .comb = true,
                        .in_short = "distance",
                        .says = "distance between joints or welds"},
                       {.name = "depth_m",
                        .unit = "m",
                        .low = 5e-5,
                        .high = 1e-2,
                        .typical = 1e-3,
                        .spread = Spread::logarithmic,
                        .strength = true,
                        .nothing = 0.0,
                        .amplitude = true,
                        .simulated = {.high = 5e-3, .standard = 5e-4},
                        .in_short = "depth of the dip",
                        .says = "depth of a dip"},
                       {.name = "length_m",
                        .unit = "m",
                        .low = 0.05,
                        .high = 3.0,
                        .typical = 1.0,
                        .spread = Spread::logarithmic,
                        .simulated = {.high = 2.0, .standard = 0.5},
                        .in_short = "its length",
                        .says = "length of a dip"}},
        .elements = {Element::irregularity},
        .bands = {{0.5, 100.0}},
        .mimics =
            "A rougher track: where the lines are closer than the resolution only their impulsive shape in time "
            "remains. Regularly failed fasteners have lines of the same kind; theirs follow the wheel load.",
        .draws = {{.parameters = {{.name = "spacing_m", .low = 8.0, .high = 40.0, .spacing = DrawSpacing::logarithmic},
                                  {.name = "depth_m", .low = 1e-4, .high = 2e-3, .spacing = DrawSpacing::logarithmic},
                                  {.name = "length_m", .low = 0.3, .high = 1.5, .spacing = DrawSpacing::logarithmic}},
                   .strength = "depth_m"}},
    };
}

}  // namespace railpem::effects
