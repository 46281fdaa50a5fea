#include "effects/catalogue.hpp"

namespace railpem::effects {

EffectDescription rail_damper() {
    return {
        .id = "rail-damper",
        .row = 70,
        .says = "tuned masses hang on the rail and take energy out of it near their frequency",
        .in_short = "tuned masses hang on the rail",
        .equation =
            "added mass per metre of rail m_d ω_d²(1 + iη)/(ω_d²(1 + iη) − ω²), η = loss_factor·(ω/ω_d)^p; one "
            "instance per mass of the damper",
        .source = "Thompson, Jones, Waters & Farrington 2007, Applied Acoustics 68",
        .parameters = {{.name = "mass_kg_per_m",
                        .unit = "kg/m",
                        .low = 2.0,
                        .high = 40.0,
                        .typical = 15.0,
                        .spread = Spread::logarithmic,
                        .strength = true,
                        .nothing = 0.0,
                        .in_short = "per metre of rail",
                        .says = "damper mass per metre of rail"},
                       {.name = "frequency_hz",
                        .unit = "Hz",
                        .low = 30.0,
                        .high = 6000.0,
                        .typical = 500.0,
                        .spread = Spread::logarithmic,
                        .simulated = {.high = 2000.0, .standard = 120.0},
                        .in_short = "on a fixed rail",
                        .says = "frequency of the mass on a fixed rail"},
                       {.name = "loss_factor",
                        .unit = "1",
                        .low = 0.05,
                        .high = 1.0,
                        .typical = 0.35,
                        .spread = Spread::logarithmic,
                        .in_short = "of its dashpot, at its own frequency",
                        .says = "loss factor of the elastomer at its frequency"},
                       {.name = "loss_exponent",
                        .unit = "1",
                        .low = 0.0,
                        .high = 1.0,
                        .typical = 0.0,
                        .law = true,
                        .says =
                            "exponent p with which the loss factor grows, (f/f_d)^p: 0 for rubber, 1 for a dashpot"}},
        .elements = {Element::rail},
        .bands = {{40.0, 6000.0}},
        .mimics =
            "Well below its frequency it is a heavier rail (parameter-error of track.rail.mass_kg_per_m) and a running "
            "train says little more; decay rates along the rail, or a receptance through its frequency, decide. "
            "sleeper-flexibility makes a similar pair of dip and peak but only over the supports.",
        .most_instances = 2,  // dampers with two masses
        // Beyond the 175 Hz that a diagnosis looks at, a damper shows by its mass alone.
        .draws =
            {{.parameters = {{.name = "mass_kg_per_m", .low = 2.0, .high = 40.0, .spacing = DrawSpacing::logarithmic},
                             {.name = "frequency_hz", .low = 40.0, .high = 250.0, .spacing = DrawSpacing::logarithmic},
                             {.name = "loss_factor", .low = 0.08, .high = 0.6, .spacing = DrawSpacing::logarithmic}},
              .strength = "mass_kg_per_m"}},
    };
}

}  // namespace railpem::effects
