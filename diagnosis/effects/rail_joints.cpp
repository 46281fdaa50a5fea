#include "diagnosis/effects/catalogue.hpp"

namespace railpem::diagnosis {

Effect rail_joints() {
    return {
        .id = "rail-joints",
        .says = "there are dips at a regular distance: joints or welds that have sunk",
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
                        .says = "depth of a dip"},
                       {.name = "length_m",
                        .unit = "m",
                        .low = 0.05,
                        .high = 3.0,
                        .typical = 1.0,
                        .spread = Spread::logarithmic,
                        .says = "length of a dip"}},
        .elements = {Element::irregularity},
        .bands = {{0.5, 100.0}},
        .mimics =
            "A rougher track: where the lines are closer than the resolution only their impulsive shape in time "
            "remains. Regularly failed fasteners have lines of the same kind; theirs follow the wheel load.",
        .lines_alone = true,
        .obstacle = {},
        .apply =
            [](pem::CaseParameters& parameters, const EffectInstance& effect, const ParameterAccess&) {
                parameters.irregularity.joints.push_back({.spacing_m = effect.values.at("spacing_m"),
                                                          .depth_m = effect.values.at("depth_m"),
                                                          .length_m = effect.values.at("length_m")});
            },
    };
}

}  // namespace railpem::diagnosis
