#include "diagnosis/effects/catalogue.hpp"

namespace railpem::diagnosis {

Effect rail_damper() {
    return {
        .id = "rail-damper",
        .says = "tuned masses hang on the rail and take energy out of it near their frequency",
        .equation =
            "added mass per metre of rail m_d ω_d²(1 + iη)/(ω_d²(1 + iη) − ω²); one instance per mass of the damper",
        .source = "Thompson, Jones, Waters & Farrington 2007, Applied Acoustics 68",
        .parameters = {{.name = "mass_kg_per_m",
                        .unit = "kg/m",
                        .low = 2.0,
                        .high = 40.0,
                        .typical = 15.0,
                        .spread = Spread::logarithmic,
                        .strength = true,
                        .nothing = 0.0,
                        .inexact = 0.03,  // scripts/interval_misses.py
                        .says = "damper mass per metre of rail"},
                       {.name = "frequency_hz",
                        .unit = "Hz",
                        .low = 30.0,
                        .high = 6000.0,
                        .typical = 500.0,
                        .spread = Spread::logarithmic,
                        .inexact = 0.014,  // scripts/interval_misses.py
                        .says = "frequency of the mass on a fixed rail"},
                       {.name = "loss_factor",
                        .unit = "1",
                        .low = 0.05,
                        .high = 1.0,
                        .typical = 0.35,
                        .spread = Spread::logarithmic,
                        .inexact = 0.085,  // scripts/interval_misses.py
                        .says = "loss factor of the elastomer"}},
        .elements = {Element::rail},
        .bands = {{40.0, 6000.0}},
        .mimics =
            "Well below its frequency it is a heavier rail (parameter-error of track.rail.mass_kg_per_m) and a running "
            "train says little more; decay rates along the rail, or a receptance through its frequency, decide. "
            "sleeper-flexibility makes a similar pair of dip and peak but only over the supports.",
        .most_instances = 2,  // dampers with two masses
        .approximate = true,  // a loss factor that is the same at all frequencies: rubber comes near, dashpots equal it at one
        .obstacle = {},
        .apply =
            [](pem::CaseParameters& parameters, const EffectInstance& effect, const ParameterAccess&) {
                parameters.track.rail_dampers.push_back({.mass_kg_per_m = effect.values.at("mass_kg_per_m"),
                                                         .frequency_hz = effect.values.at("frequency_hz"),
                                                         .loss_factor = effect.values.at("loss_factor")});
            },
    };
}

}  // namespace railpem::diagnosis
