#include "diagnosis/effects/catalogue.hpp"

namespace railpem::diagnosis {

Effect bogie_mounted_mass() {
    return {
        .id = "bogie-mounted-mass",
        .says = "motors or equipment hang elastically on the bogie frame",
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
                        .says = "mass on each bogie"},
                       {.name = "frequency_hz",
                        .unit = "Hz",
                        .low = 5.0,
                        .high = 80.0,
                        .typical = 20.0,
                        .spread = Spread::logarithmic,
                        .says = "frequency of the mass on a fixed frame"},
                       {.name = "damping_ratio",
                        .unit = "1",
                        .low = 0.01,
                        .high = 0.5,
                        .typical = 0.1,
                        .spread = Spread::logarithmic,
                        .inexact = 0.003,  // scripts/interval_misses.py
                        .says = "damping ratio of the mounting"}},
        .elements = {Element::bogie},
        .bands = {{4.0, 100.0}},
        .mimics =
            "Well below its frequency a heavier bogie (parameter-error of vehicle.bogie_mass_kg). Around it the dip "
            "and peak of the ratio bogie to axle box stay at their frequency whatever the speed, and no suspension "
            "has them.",
        .obstacle = {},
        .apply =
            [](pem::CaseParameters& parameters, const EffectInstance& effect, const ParameterAccess&) {
                // A mass of nothing would be a degree of freedom with neither inertia nor stiffness.
                if (effect.values.at("mass_kg") == 0.0) return;
                parameters.vehicle.bogie_mounted_masses.push_back({.mass_kg = effect.values.at("mass_kg"),
                                                                   .frequency_hz = effect.values.at("frequency_hz"),
                                                                   .damping_ratio = effect.values.at("damping_ratio")});
            },
    };
}

}  // namespace railpem::diagnosis
