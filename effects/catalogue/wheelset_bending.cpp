#include <limits>

#include "effects/catalogue.hpp"

namespace railpem::effects {

EffectDescription wheelset_bending() {
    return {
        .id = "wheelset-bending",
        .row = 150,
        .says = "the axles bend, so the wheels have a mode of their own beside moving with the wheelset",
        .in_short = "the axle bends",
        .equation =
            "wheel displacement = rigid displacement + q, m(q̈ + 2ζωq̇ + ω²q) = contact force − primary "
            "suspension; the same on every wheelset",
        .source =
            "Carrarini, Kaiser & Schupp 2004, Recent Enhancements of Running Behaviour Analysis, DLR (elastic "
            "wheelsets)",
        .parameters = {{.name = "frequency_hz",
                        .unit = "Hz",
                        .low = 50.0,
                        .high = 110.0,
                        .typical = 80.0,
                        .inexact = 0.001,  // scripts/interval_misses.py
                        .in_short = "of the free wheelset",
                        .says = "first bending frequency of the free wheelset"},
                       {.name = "damping_ratio",
                        .unit = "1",
                        .low = 0.001,
                        .high = 0.1,
                        .typical = 0.01,
                        .spread = Spread::logarithmic,
                        .inexact = 0.04,  // scripts/interval_misses.py
                        .simulated = {.low = 0.002},
                        .in_short = "of the mode",
                        .says = "damping ratio of the mode"},
                       {.name = "modal_mass_kg",
                        .unit = "kg",
                        .low = 100.0,
                        .high = 2e4,
                        .typical = 3000.0,
                        .spread = Spread::logarithmic,
                        .strength = true,
                        .nothing = std::numeric_limits<double>::infinity(),
                        .inexact = 0.02,  // scripts/interval_misses.py
                        .simulated = {.high = 3000.0, .standard = 600.0},
                        .in_short = "whole wheelset",
                        .says = "modal mass of the whole wheelset for unit displacement at the wheels: several times "
                                "the wheelset's own, because its nodes lie near the wheels"}},
        .elements = {Element::wheel},
        .bands = {{40.0, 130.0}},
        .mimics =
            "A corrugation at one speed; it moves with the speed, the mode does not. A track resonance of the same "
            "frequency also shows in a receptance of the track alone. Ratios between bogie and axle box do not see "
            "the mode, because axle box and suspension ride on it.",
        .draws = {{.parameters =
                       {{.name = "frequency_hz", .low = 52.0, .high = 105.0},
                        {.name = "damping_ratio", .low = 0.004, .high = 0.05, .spacing = DrawSpacing::logarithmic},
                        {.name = "modal_mass_kg", .low = 300.0, .high = 3000.0, .spacing = DrawSpacing::logarithmic}},
                   .strength = "modal_mass_kg"}},
    };
}

}  // namespace railpem::effects
