#include <limits>

#include "effects/catalogue.hpp"

namespace railpem::effects {

EffectDescription sleeper_flexibility() {
    return {
        .id = "sleeper-flexibility",
        .row = 60,
        .says = "the sleeper bends under the rail instead of moving as a rigid block",
        .in_short = "the sleeper bends",
        .equation =
            "adds to the compliance below each pad 1/(m_n[ω_n²(1 + iη_n) − ω²] + (k(1 + iη) + iωc)·m_n/M), a free "
            "mode of a beam on the same ballast; one instance per mode",
        .source = "Knothe & Grassie 1993, Vehicle System Dynamics 22",
        .parameters = {{.name = "frequency_hz",
                        .unit = "Hz",
                        .low = 60.0,
                        .high = 500.0,
                        .typical = 130.0,
                        .spread = Spread::logarithmic,
                        .simulated = {.high = 250.0},
                        .in_short = "free-free",
                        .says = "frequency of the mode of the free sleeper"},
                       {.name = "loss_factor",
                        .unit = "1",
                        .low = 0.005,
                        .high = 0.3,
                        .typical = 0.03,
                        .spread = Spread::logarithmic,
                        .simulated = {.high = 0.2, .standard = 0.05},
                        .in_short = "of the mode",
                        .says = "loss factor of the mode"},
                       {.name = "modal_mass_kg",
                        .unit = "kg",
                        .low = 20.0,
                        .high = 3000.0,
                        .typical = 150.0,
                        .spread = Spread::logarithmic,
                        .strength = true,
                        .nothing = std::numeric_limits<double>::infinity(),
                        .simulated = {.high = 300.0, .standard = 80.0},
                        .in_short = "per seat, for unit displacement there",
                        .says = "modal mass per rail seat for unit displacement there; large when the seat is near a "
                                "node of the mode"}},
        .elements = {Element::support},
        .bands = {{80.0, 250.0}},
        .mimics =
            "A rail damper of the same frequency. The sleeper's mode keeps its frequency with the load and appears "
            "at the sleeper; a hammer test on the sleeper decides.",
        // Only where the case has sleepers.
        .draws = {{.parameters =
                       {{.name = "frequency_hz", .low = 60.0, .high = 200.0, .spacing = DrawSpacing::logarithmic},
                        {.name = "loss_factor", .low = 0.01, .high = 0.1, .spacing = DrawSpacing::logarithmic},
                        {.name = "modal_mass_kg", .low = 30.0, .high = 300.0, .spacing = DrawSpacing::logarithmic}},
                   .strength = "modal_mass_kg"}},
    };
}

}  // namespace railpem::effects
