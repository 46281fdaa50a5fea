#include <limits>

#include "effects/catalogue.hpp"

namespace railpem::effects {

EffectDescription body_bending() {
    return {
        .id = "body-bending",
        .row = 140,
        .says = "the car body bends like a beam instead of moving as a rigid block",
        .in_short = "the car body bends",
        .equation =
            "displacement heave + x·pitch + φ(x)·q with φ(0) = 1 and φ = shape_at_pivots over the bogies; "
            "m(q̈ + 2ζωq̇ + ω²q) = Σ φ·force of the secondary suspension",
        .source =
            "Dumitriu, Apostol & Stănică 2023, Vibration 6 (vehicle with the first vertical bending mode of its body)",
        .parameters = {{.name = "frequency_hz",
                        .unit = "Hz",
                        .low = 6.0,
                        .high = 16.0,
                        .typical = 9.5,
                        .in_short = "first free-free mode",
                        .says = "first bending frequency of the free, empty body"},
                       {.name = "damping_ratio",
                        .unit = "1",
                        .low = 0.002,
                        .high = 0.1,
                        .typical = 0.02,
                        .spread = Spread::logarithmic,
                        .inexact = 0.004,  // scripts/interval_misses.py
                        .simulated = {.standard = 0.015},
                        .in_short = "of the mode",
                        .says = "damping ratio of the mode"},
                       {.name = "modal_mass_kg",
                        .unit = "kg",
                        .low = 2e3,
                        .high = 5e4,
                        .typical = 12e3,
                        .spread = Spread::logarithmic,
                        .strength = true,
                        .nothing = std::numeric_limits<double>::infinity(),
                        .simulated = {.high = 40000.0, .standard = 9000.0},
                        .in_short = "whole body, for 1 at the centre",
                        .says =
                            "modal mass of the whole body for unit displacement at its centre; 0.68 of the mass for a "
                            "uniform beam"},
                       {.name = "shape_at_pivots",
                        .unit = "1",
                        .low = -1.2,
                        .high = 0.2,
                        .typical = -0.4,
                        .simulated = {.low = -1.0, .high = 0.0, .standard = -0.35},
                        .in_short = "over the pivots",
                        .says = "displacement over the bogie pivots for 1 at the centre"}},
        .elements = {Element::body},
        .bands = {{5.0, 20.0}},
        .mimics =
            "A softer secondary suspension or a series spring of its damper raise the body over all frequencies "
            "above its bounce, and front, centre and rear alike; bending is a narrow peak that is strongest at the "
            "centre. A channel at the centre beside one over a pivot decides.",
        .draws = {{.parameters =
                       {{.name = "frequency_hz", .low = 6.5, .high = 14.0},
                        {.name = "damping_ratio", .low = 0.005, .high = 0.05, .spacing = DrawSpacing::logarithmic},
                        {.name = "modal_mass_kg", .low = 4000.0, .high = 40000.0, .spacing = DrawSpacing::logarithmic},
                        {.name = "shape_at_pivots", .low = -0.6, .high = -0.2}},
                   .strength = "modal_mass_kg"}},
    };
}

}  // namespace railpem::effects
