#include "effects/catalogue.hpp"

namespace railpem::effects {

EffectDescription pad_frequency_stiffening() {
    return {
        .id = "pad-frequency-stiffening",
        .row = 10,
        .says = "the rail pads grow stiffer, and dissipate more, the faster they are deformed",
        .in_short = "the pad stiffens with frequency",
        .equation =
            "K(f) = K0 (f/f0)^k (1 + i tan(πk/2)), the spring-pot; the dashpot stays. The exponent adds to the case's "
            "own; a case that has one already keeps its own form, causal or not",
        .source =
            "Fenander 1997, Proc. IMechE F 211; Maes, Sol & Guillaume 2006, J. Sound Vib. 293; Wei et al. 2016, "
            "Shock and Vibration, eq. (10)",
        .parameters = {{.name = "exponent",
                        .unit = "1",
                        .low = 0.02,
                        .high = 0.35,
                        .typical = 0.15,
                        .strength = true,
                        .nothing = 0.0,
                        .inexact = 0.012,  // scripts/interval_misses.py
                        .in_short = "k in K0 (f/f0)^k (1 + i tan(pi k/2))",
                        .says = "the exponent k: ten times the frequency is 10^k times the stiffness"}},
        .elements = {Element::pad},
        .bands = {{30.0, 200.0}},
        .mimics =
            "A pad that is simply stiffer and has another dashpot (parameter-error of the pad) hides nearly all of "
            "it at one speed. Other speeds move the wheel comb through the band and tell them apart; a hammer test or "
            "a decay rate over a decade of frequency decides. pad-hysteresis has the same flat loss angle but no "
            "dashpot beside it: the loss above 100 Hz differs.",
        .draws = {{.parameters = {{.name = "exponent", .low = 0.02, .high = 0.35, .spacing = DrawSpacing::logarithmic}},
                   .strength = "exponent"}},
    };
}

}  // namespace railpem::effects
