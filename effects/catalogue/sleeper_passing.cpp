#include "effects/catalogue.hpp"

namespace railpem::effects {

EffectDescription sleeper_passing() {
    return {
        .id = "sleeper-passing",
        .row = 90,
        .says = "the wheels feel the supports passing under them more than the believed track explains",
        .in_short = "supports are felt more than the case says",
        .equation =
            "lines at n·v/spacing with the wheels' delays; amplitude = factor × own × the difference of the "
            "deflection under the standing load over and between the pads, own = the case's amplitude_factor, or 1 "
            "when the case does not model it",
        .source = "Wu & Thompson 2004, J. Sound Vib. 278; Nordborg 1998, Acustica united with Acta Acustica 84",
        .parameters = {{.name = "amplitude_factor",
                        .unit = "1",
                        .low = 1.0,
                        .high = 20.0,
                        .typical = 3.0,
                        .spread = Spread::logarithmic,
                        .strength = true,
                        .nothing = 1.0,
                        .simulated = {.low = 0.0},
                        .in_short = "over the case's own",
                        .says = "amplitude over that of the case's own compliance; 1 is no excess"}},
        .elements = {Element::irregularity},
        .bands = {{20.0, 150.0}},
        .mimics =
            "A corrugation of the support spacing. rail-shear also raises the line (fourfold on the track of Wei et "
            "al. 2016), without raising its harmonics alike. A second load moves this line in proportion; a second "
            "speed moves both.",
        .draws = {{.parameters = {{.name = "amplitude_factor",
                                   .low = 0.3,
                                   .high = 9.0,
                                   .spacing = DrawSpacing::logarithmic,
                                   .offset = 1.0}},
                   .strength = "amplitude_factor"}},
    };
}

}  // namespace railpem::effects
