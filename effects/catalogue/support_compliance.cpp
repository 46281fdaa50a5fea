#include <limits>

#include "effects/catalogue.hpp"

namespace railpem::effects {

EffectDescription support_compliance() {
    return {
        .id = "support-compliance",
        .row = 50,
        .says =
            "there is a mass on a spring under the pads: a sleeper on ballast, or a slab on a mat, instead of rigid "
            "ground",
        .in_short = "there is a mass and a spring under the pads",
        .equation = "compliance below each pad 1/(k + iωc − ω²M)",
        .source = "Knothe & Grassie 1993, Vehicle System Dynamics 22",
        .parameters = {{.name = "mass_kg",
                        .unit = "kg",
                        .low = 20.0,
                        .high = 2000.0,
                        .typical = 150.0,
                        .spread = Spread::logarithmic,
                        .in_short = "per seat",
                        .says = "mass under one rail seat: half a sleeper, or a piece of slab"},
                       {.name = "stiffness_n_per_m",
                        .unit = "N/m",
                        .low = 5e6,
                        .high = 5e8,
                        .typical = 60e6,
                        .spread = Spread::logarithmic,
                        .strength = true,
                        .nothing = std::numeric_limits<double>::infinity(),
                        .simulated = {.standard = 1e8},
                        .in_short = "per seat",
                        .says = "spring under that mass, per rail seat: ballast or mat"},
                       {.name = "damping_n_s_per_m",
                        .unit = "N s/m",
                        .low = 1e3,
                        .high = 1e6,
                        .typical = 5e4,
                        .spread = Spread::logarithmic,
                        .simulated = {.low = 0.0, .standard = 8e4},
                        .in_short = "per seat",
                        .says = "dashpot under that mass, per rail seat"}},
        .elements = {Element::support},
        .bands = {{20.0, 200.0}},
        .mimics =
            "Softer pads (parameter-error of the pad) below the frequency of mass and spring; above it the mass "
            "stands still and the track is as stiff as believed, which softer pads never are. sleeper-flexibility "
            "and rail-damper also make a dip and a peak; a receptance at the sleeper, or more than one speed, "
            "separates.",
        .draws = {{.parameters =
                       {{.name = "mass_kg", .low = 40.0, .high = 500.0, .spacing = DrawSpacing::logarithmic},
                        {.name = "stiffness_n_per_m", .low = 3e7, .high = 4e8, .spacing = DrawSpacing::logarithmic},
                        {.name = "damping_n_s_per_m", .low = 2e4, .high = 2e5, .spacing = DrawSpacing::logarithmic}},
                   .strength = "stiffness_n_per_m"}},
    };
}

}  // namespace railpem::effects
