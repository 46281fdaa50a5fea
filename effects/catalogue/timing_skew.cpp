#include "effects/catalogue.hpp"
#include "effects/choices.hpp"

namespace railpem::effects {

EffectDescription timing_skew() {
    return {
        .id = "timing-skew",
        .row = 250,
        .says = "a channel is shifted in time against the others",
        .in_short = "a channel is shifted in time",
        .equation = "channel × e^(−iωτ): phase linear in frequency, and the same τ at every speed",
        .source = "Bendat & Piersol 2010, Random Data, ch. 5 (time delays in cross-spectra)",
        .parameters = {{.name = "delay_s",
                        .unit = "s",
                        .low = -1.0,
                        .high = 1.0,
                        .typical = 2e-3,
                        .strength = true,
                        .nothing = 0.0,
                        .least = 1e-5,  // a hundredth of a sample at 1 kHz
                        .simulated = {.standard = 0.005},
                        .in_short = "positive: late",
                        .says = "the channel is late by this time"}},
        .choices = {channel_choice()},
        .elements = {Element::sensor},
        .bands = {{0.3, 500.0}},
        .mimics =
            "A wrong position or wheelbase, or a wrong speed: their delays scale with 1/v. No spectrum of a single "
            "channel shows it.",
        .draws = {{.parameters = {{.name = "delay_s",
                                   .low = 2e-4,
                                   .high = 2e-2,
                                   .spacing = DrawSpacing::logarithmic,
                                   .mirror = DrawMirror::sign}},
                   .strength = "delay_s"}},
    };
}

}  // namespace railpem::effects
