#include "effects/catalogue.hpp"

namespace railpem::effects {

EffectDescription parameter_error() {
    return {
        .id = "parameter-error",
        .row = 260,
        .says = "nothing is missing: a value that was believed is wrong, beyond its tolerance",
        .in_short = "nothing is missing: a believed value is wrong",
        .equation = "value = factor × believed value",
        .source = "the case itself: its values and their tolerances",
        .parameters = {{.name = "factor",
                        .unit = "1",
                        .low = 0.1,
                        .high = 10.0,
                        .typical = 1.4,
                        .spread = Spread::logarithmic,
                        .strength = true,
                        .nothing = 1.0,
                        .simulated = {.standard = 1.3},
                        .in_short = "true over believed value",
                        .says = "true value over believed value"}},
        .choices = {{.name = "parameter",
                     .in_short = "dotted key of the case",
                     .says = "dotted key of a number of the case"}},
        .elements = {Element::secondary, Element::primary, Element::body, Element::bogie, Element::wheel,
                     Element::contact, Element::rail, Element::pad, Element::support, Element::irregularity,
                     Element::sensor},
        .bands = {{0.3, 200.0}},
        .mimics =
            "Any effect that one wrong value can imitate; what each effect says about its rivals tells the two apart.",
        .wrong_number = true,
        .draws = {{.parameters = {{.name = "factor",
                                   .low = 1.4,
                                   .high = 2.5,
                                   .spacing = DrawSpacing::logarithmic,
                                   .mirror = DrawMirror::inverse}},
                   .strength = "factor"}},
    };
}

}  // namespace railpem::effects
