#include "effects/catalogue.hpp"

namespace railpem::effects {

EffectDescription body_coupling() {
    return {
        .id = "body-coupling",
        .row = 300,
        .says = "a buffer ties the end of the body to the neighbouring car",
        .parameters = {{.name = "stiffness_n_per_m",
                        .unit = "N/m",
                        .low = 1e4,
                        .high = 1e7,
                        .typical = 8e5,
                        .strength = true,
                        .says = "of the buffer"},
                       {.name = "damping_n_s_per_m",
                        .unit = "N s/m",
                        .low = 0.0,
                        .high = 2e5,
                        .typical = 1e4,
                        .says = "of the buffer"},
                       {.name = "neighbour_mass_kg",
                        .unit = "kg",
                        .low = 2000.0,
                        .high = 40000.0,
                        .typical = 15000.0,
                        .says = "that moves with the neighbour's end"},
                       {.name = "neighbour_frequency_hz",
                        .unit = "Hz",
                        .low = 0.5,
                        .high = 12.0,
                        .typical = 1.3,
                        .says = "of the neighbour on its suspension"},
                       {.name = "neighbour_damping_ratio",
                        .unit = "1",
                        .low = 0.01,
                        .high = 1.0,
                        .typical = 0.15,
                        .says = "of its suspension"},
                       {.name = "position_m",
                        .unit = "m",
                        .low = -15.0,
                        .high = 15.0,
                        .typical = -11.0,
                        .says = "of the buffer from the body's centre"}},
        .elements = {Element::body},
        .only_simulated = true,
        .draws =
            {{.parameters =
                  {{.name = "stiffness_n_per_m", .low = 1e5, .high = 5e6, .spacing = DrawSpacing::logarithmic},
                   {.name = "damping_n_s_per_m", .low = 1e3, .high = 1e5, .spacing = DrawSpacing::logarithmic},
                   {.name = "neighbour_mass_kg", .low = 5000.0, .high = 30000.0, .spacing = DrawSpacing::logarithmic},
                   {.name = "neighbour_frequency_hz", .low = 0.8, .high = 6.0, .spacing = DrawSpacing::logarithmic},
                   {.name = "neighbour_damping_ratio", .low = 0.05, .high = 0.3, .spacing = DrawSpacing::logarithmic},
                   {.name = "position_m", .low = 9.0, .high = 12.0, .mirror = DrawMirror::sign}},
              .strength = "stiffness_n_per_m"}},
    };
}

}  // namespace railpem::effects
