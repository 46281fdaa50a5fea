#include "effects/catalogue.hpp"
#include "effects/choices.hpp"

namespace railpem::effects {

EffectDescription sensor_noise() {
    return {
        .id = "sensor-noise",
        .row = 240,
        .says = "a channel carries noise, drift or 1/f noise that has nothing to do with the train",
        .in_short = "noise, drift or 1/f on a channel",
        .equation =
            "adds S(f) ∝ f^(slope/(10·log10 2)) with an integral of rms² from 0.5 to 500 Hz to one element of the "
            "diagonal of the cross-spectral matrix",
        .source = "Bendat & Piersol 2010, Random Data, ch. 6 (extraneous noise)",
        .parameters = {{.name = "rms_m_per_s2",
                        .unit = "m/s^2",
                        .low = 1e-6,
                        .high = 100.0,
                        .typical = 0.1,
                        .spread = Spread::logarithmic,
                        .strength = true,
                        .nothing = 0.0,
                        .amplitude = true,
                        .in_short = "of the noise",
                        .says = "rms of the noise, 0.5 to 500 Hz"},
                       {.name = "slope_db_per_octave",
                        .unit = "dB",
                        .low = -12.0,
                        .high = 6.0,
                        .typical = -3.0,
                        .inexact = 0.03,  // scripts/interval_misses.py
                        .simulated = {.standard = 0.0},
                        .in_short = "of its spectrum",
                        .says = "slope of its spectrum; −3: 1/f, −6: drift like a random walk"}},
        .choices = {channel_choice()},
        .elements = {Element::sensor},
        .bands = {{0.3, 500.0}},
        .mimics = "More vibration at that place: but that is coherent with the other channels, noise is not.",
        .draws =
            {{.parameters = {{.name = "rms_m_per_s2", .low = 0.03, .high = 1.0, .spacing = DrawSpacing::logarithmic},
                             {.name = "slope_db_per_octave", .low = -6.0, .high = 0.0}},
              .strength = "rms_m_per_s2"}},
    };
}

}  // namespace railpem::effects
