#include "effects/catalogue.hpp"

namespace railpem::effects {

EffectDescription pad_hysteresis() {
    return {
        .id = "pad-hysteresis",
        .row = 30,
        .says =
            "the pad dissipates the same share of its energy at every frequency (a loss factor) instead of like a "
            "dashpot",
        .in_short = "the pad dissipates by a loss factor, not by a dashpot",
        .equation =
            "K(f) = K_const (f/30 Hz)^((2/π) atan η) (1 + iη), the causal law of a flat loss factor; it replaces "
            "the dashpot, so there is no strength at which it fades into the case",
        .source = "Thompson & Verheij 1997, Applied Acoustics 52",
        .parameters = {{.name = "loss_factor",
                        .unit = "1",
                        .low = 0.05,
                        .high = 1.0,
                        .typical = 0.25,
                        .spread = Spread::logarithmic,
                        .inexact = 0.003,  // scripts/interval_misses.py
                        .in_short = "eta of the flat causal loss",
                        .says = "the loss factor η: imaginary over real part of the stiffness"}},
        .elements = {Element::pad},
        .bands = {{30.0, 200.0}},
        .mimics =
            "Another dashpot (parameter-error of track.pads.damping_n_s_per_m) with the same loss at the wheel's "
            "resonance; they part below and above it: the dashpot's loss grows with frequency, this one does not. "
            "pad-frequency-stiffening keeps the dashpot.",
        .draws =
            {{.parameters = {{.name = "loss_factor", .low = 0.05, .high = 1.0, .spacing = DrawSpacing::logarithmic}}}},
    };
}

}  // namespace railpem::effects
