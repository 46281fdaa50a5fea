#include <limits>

#include "effects/catalogue.hpp"
#include "effects/choices.hpp"

namespace railpem::effects {

EffectDescription sensor_resonance() {
    return {
        .id = "sensor-resonance",
        .row = 230,
        .says = "the mounting of a sensor resonates and raises what it reads near that frequency",
        .in_short = "a sensor mount resonates",
        .equation = "channel × 1/(1 − (f/f_m)² + 2iζf/f_m): one row and one column of the cross-spectral matrix",
        .source = "ISO 5348 (mechanical mounting of accelerometers)",
        .parameters = {{.name = "frequency_hz",
                        .unit = "Hz",
                        .low = 10.0,
                        .high = 2000.0,
                        .typical = 250.0,
                        .spread = Spread::logarithmic,
                        .strength = true,
                        .nothing = std::numeric_limits<double>::infinity(),
                        .simulated = {.high = 1000.0, .standard = 150.0},
                        .in_short = "of the mount",
                        .says = "frequency of the sensor on its mounting"},
                       {.name = "damping_ratio",
                        .unit = "1",
                        .low = 0.005,
                        .high = 0.7,
                        .typical = 0.05,
                        .spread = Spread::logarithmic,
                        .in_short = "of the mount",
                        .says = "its damping ratio"}},
        .choices = {channel_choice()},
        .elements = {Element::sensor},
        .bands = {{40.0, 500.0}},
        .mimics =
            "A mode of the part that carries the sensor; that one moves its neighbours as well. Well below its "
            "frequency it is a gain that grows with f².",
        .draws =
            {{.parameters = {{.name = "frequency_hz", .low = 60.0, .high = 400.0, .spacing = DrawSpacing::logarithmic},
                             {.name = "damping_ratio", .low = 0.01, .high = 0.2, .spacing = DrawSpacing::logarithmic}},
              .strength = "frequency_hz"}},
    };
}

}  // namespace railpem::effects
