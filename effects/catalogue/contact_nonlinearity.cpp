#include "effects/catalogue.hpp"

namespace railpem::effects {

EffectDescription contact_nonlinearity() {
    return {
        .id = "contact-nonlinearity",
        .row = 200,
        .says = "the contact of wheel and rail softens and opens under vibration more than believed",
        .in_short = "the contact opens or stiffens more than the case says",
        .equation =
            "P = (δ/G)^{3/2}, by statistical linearisation K = ∂E[P]/∂δ̄ with E[P] = P0; K_h + factor × own × (K − "
            "K_h), own = the case's nonlinearity_factor, or 1 when the case is linear",
        .source =
            "Wei et al. 2016, Shock and Vibration, eqs. (4) to (8); Roberts & Spanos 1990, Random Vibration and "
            "Statistical Linearization",
        .parameters = {{.name = "factor",
                        .unit = "1",
                        .low = 1.0,
                        .high = 5.0,
                        .typical = 3.0,
                        .strength = true,
                        .nothing = 1.0,
                        .inexact = 0.035,  // docs/theory/diagnosis.md
                        .least = 0.15,     // what a contact distorts is known within the tolerance of its constant
                        .simulated = {.low = 0.0, .standard = 2.0},
                        .in_short = "share of the Hertz law's nonlinearity",
                        .says = "nonlinearity over that of the case; 1 is no excess"}},
        .elements = {Element::contact},
        .bands = {{80.0, 200.0}},
        .mimics =
            "A softer contact (parameter-error of contact.constant_m_per_n23); the nonlinear one goes with the level "
            "of excitation, so a rougher section or a higher speed separates.",
        .draws = {{.parameters = {{.name = "factor", .low = 1.3, .high = 5.0, .spacing = DrawSpacing::logarithmic}},
                   .strength = "factor"}},
    };
}

}  // namespace railpem::effects
