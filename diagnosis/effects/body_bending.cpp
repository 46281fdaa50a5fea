#include <limits>

#include "diagnosis/effects/catalogue.hpp"

namespace railpem::diagnosis {

Effect body_bending() {
    return {
        .id = "body-bending",
        .says = "the car body bends like a beam instead of moving as a rigid block",
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
                        .says = "first bending frequency of the free, empty body"},
                       {.name = "damping_ratio",
                        .unit = "1",
                        .low = 0.002,
                        .high = 0.1,
                        .typical = 0.02,
                        .spread = Spread::logarithmic,
                        .inexact = 0.004,  // scripts/interval_misses.py
                        .says = "damping ratio of the mode"},
                       {.name = "modal_mass_kg",
                        .unit = "kg",
                        .low = 2e3,
                        .high = 5e4,
                        .typical = 12e3,
                        .spread = Spread::logarithmic,
                        .strength = true,
                        .nothing = std::numeric_limits<double>::infinity(),
                        .says =
                            "modal mass of the whole body for unit displacement at its centre; 0.68 of the mass for a "
                            "uniform beam"},
                       {.name = "shape_at_pivots",
                        .unit = "1",
                        .low = -1.2,
                        .high = 0.2,
                        .typical = -0.4,
                        .says = "displacement over the bogie pivots for 1 at the centre"}},
        .elements = {Element::body},
        .bands = {{5.0, 20.0}},
        .mimics =
            "A softer secondary suspension or a series spring of its damper raise the body over all frequencies "
            "above its bounce, and front, centre and rear alike; bending is a narrow peak that is strongest at the "
            "centre. A channel at the centre beside one over a pivot decides.",
        .obstacle = [](const pem::CaseParameters& parameters) -> std::optional<Obstacle> {
            if (parameters.vehicle.body_bending.empty()) return std::nullopt;
            return Obstacle{"the body of the case bends already", "a case without [[vehicle.body_bending]]"};
        },
        .apply =
            [](pem::CaseParameters& parameters, const EffectInstance& effect, const ParameterAccess&) {
                parameters.vehicle.body_bending.push_back({.frequency_hz = effect.values.at("frequency_hz"),
                                                           .damping_ratio = effect.values.at("damping_ratio"),
                                                           .modal_mass_kg = effect.values.at("modal_mass_kg"),
                                                           .shape_at_pivots = effect.values.at("shape_at_pivots")});
            },
    };
}

}  // namespace railpem::diagnosis
