#include "diagnosis/effects/effect.hpp"

namespace railpem::diagnosis {

EffectInModel contact_nonlinearity() {
    return {
        // its distortion grows with the square of the factor, its stiffness falls: at 1 the derivative may point the
        // wrong way (a factor of 2 was missed so)
        .abrupt = true,
        .approximate = true,
        .follows_level = true,
        .apply =
            [](pem::CaseParameters& parameters, const EffectInstance& effect, const ParameterAccess&) {
                double& own = parameters.contact.nonlinearity_factor;
                own = (own == 0.0 ? 1.0 : own) * effect.values.at("factor");
            },
    };
}

}  // namespace railpem::diagnosis
