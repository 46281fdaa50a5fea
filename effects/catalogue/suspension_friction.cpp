#include "effects/catalogue.hpp"

namespace railpem::effects {

EffectDescription suspension_friction() {
    return {
        .id = "suspension-friction",
        .row = 190,
        .says =
            "there is dry friction in the suspension: it damps strongly when little moves and hardly when much does",
        .in_short = "dry friction: damping that depends on the level",
        .equation =
            "F·sgn(u̇), by statistical linearisation c = F·√(2/π)/σ with σ the rms velocity that results; adds to "
            "the case's own; a diagnosis also expects what is left, a force of correlation F²·(2/π)·(asin ρ − ρ) with "
            "ρ "
            "that of the velocities",
        .source =
            "Roberts & Spanos 1990, Random Vibration and Statistical Linearization; Bruni et al. 2011, Vehicle System "
            "Dynamics 49; van Vleck & Middleton 1966, Proc. IEEE 54",
        .parameters = {{.name = "force_n",
                        .unit = "N",
                        .low = 50.0,
                        .high = 3e4,
                        .typical = 1500.0,
                        .spread = Spread::logarithmic,
                        .strength = true,
                        .nothing = 0.0,
                        .amplitude = true,
                        .inexact = 0.06,  // docs/theory/diagnosis.md
                        .in_short = "per element and rail side",
                        .says = "friction force of one element, per rail side"}},
        .choices = {{.name = "stage",
                     .options = {"primary", "secondary"},
                     .is_element = true,
                     .in_short = "primary or secondary",
                     .says = "the stage of the suspension"}},
        .elements = {Element::primary, Element::secondary},
        .bands = {{0.5, 50.0}},
        .mimics =
            "A stronger damper of that stage (parameter-error) at one level of excitation; a rougher section, or "
            "another speed, changes the equivalent damping of friction and leaves a damper as it is.",
        .not_told =
            "how much harder it holds at rest than it slides (stick-slip): where runs at several speeds do not rule "
            "that "
            "out the verdict is ambiguous; what holds a little harder is named, with up to 1.4 times the force of "
            "sliding",
        .draws =
            {{.parameters = {{.name = "force_n", .low = 80.0, .high = 5000.0, .spacing = DrawSpacing::logarithmic}},
              .strength = "force_n"}},
    };
}

}  // namespace railpem::effects
