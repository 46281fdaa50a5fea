#include "diagnosis/effects/catalogue.hpp"

namespace railpem::diagnosis {

Effect contact_nonlinearity() {
    return {
        .id = "contact-nonlinearity",
        .says = "the contact of wheel and rail softens and opens under vibration more than believed",
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
                        .says = "nonlinearity over that of the case; 1 is no excess"}},
        .elements = {Element::contact},
        .bands = {{80.0, 200.0}},
        .mimics =
            "A softer contact (parameter-error of contact.constant_m_per_n23); the nonlinear one goes with the level "
            "of excitation, so a rougher section or a higher speed separates.",
        // its distortion grows with the square of the factor, its stiffness falls: at 1 the derivative may point the
        // wrong way (a factor of 2 was missed so)
        .abrupt = true,
        .approximate = true,
        .obstacle = {},
        .apply =
            [](pem::CaseParameters& parameters, const EffectInstance& effect, const ParameterAccess&) {
                double& own = parameters.contact.nonlinearity_factor;
                own = (own == 0.0 ? 1.0 : own) * effect.values.at("factor");
            },
    };
}

}  // namespace railpem::diagnosis
