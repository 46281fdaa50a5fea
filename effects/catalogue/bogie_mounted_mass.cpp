#include "effects/catalogue.hpp"

namespace railpem::effects {

EffectDescription bogie_mounted_mass() {
    return {
        .id = "bogie-mounted-mass",
        .row = 160,
        .says = "motors or equipment hang elastically on the bogie frame",
        .in_short = "equipment hangs elastically on the bogie frames",
        .equation =
            "a mass m on a spring mω² and a damper 2ζmω at the centre of each bogie, in addition to the bogie's own "
            "mass; one instance per mass",
        .source = "Den Hartog 1956, Mechanical Vibrations, ch. 3 (mass on a moving frame)",
        .parameters = {{.name = "mass_kg",
                        .unit = "kg",
                        .low = 50.0,
                        .high = 2000.0,
                        .typical = 400.0,
                        .spread = Spread::logarithmic,
                        .strength = true,
                        .nothing = 0.0,
                        .in_short = "per bogie",
                        .says = "mass on each bogie"},
                       {.name = "frequency_hz",
                        .unit = "Hz",
                        .low = 5.0,
                        .high = 80.0,
                        .typical = 20.0,
                        .spread = Spread::logarithmic,
                        .in_short = "on a fixed frame",
                        .says = "frequency of the mass on a fixed frame"},
                       {.name = "damping_ratio",
                        .unit = "1",
                        .low = 0.01,
                        .high = 0.5,
                        .typical = 0.1,
                        .spread = Spread::logarithmic,
                        .inexact = 0.003,  // scripts/interval_misses.py
                        .in_short = "of its mounting",
                        .says = "damping ratio of the mounting"}},
        .only_simulated_parameters = {{.name = "position_m",
                                       .unit = "m",
                                       .low = -2.0,
                                       .high = 2.0,
                                       .typical = 0.0,
                                       .says = "from the bogie centre"}},
        .elements = {Element::bogie},
        .bands = {{4.0, 100.0}},
        .mimics =
            "Well below its frequency a heavier bogie (parameter-error of vehicle.bogie_mass_kg). Around it the dip "
            "and peak of the ratio bogie to axle box stay at their frequency whatever the speed, and no suspension "
            "has them.",
        .draws =
            {{.parameters = {{.name = "mass_kg", .low = 50.0, .high = 1500.0, .spacing = DrawSpacing::logarithmic},
                             {.name = "frequency_hz", .low = 6.0, .high = 60.0, .spacing = DrawSpacing::logarithmic},
                             {.name = "damping_ratio", .low = 0.02, .high = 0.3, .spacing = DrawSpacing::logarithmic}},
              .strength = "mass_kg"}},
    };
}

}  // namespace railpem::effects
