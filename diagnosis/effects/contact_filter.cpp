#include "diagnosis/effects/effect.hpp"

namespace railpem::diagnosis {

EffectInModel contact_filter() {
    return {
        .obstacle = [](const pem::CaseParameters& parameters) -> std::optional<Obstacle> {
            if (parameters.contact.patch_half_length_m == 0.0) return std::nullopt;
            return Obstacle{"the contact of the case averages short waves already",
                            "a case with contact.patch_half_length_m = 0; another length is a parameter-error"};
        },
        .apply =
            [](pem::CaseParameters& parameters, const EffectInstance& effect, const ParameterAccess&) {
                parameters.contact.patch_half_length_m = effect.values.at("patch_half_length_m");
            },
    };
}

}  // namespace railpem::diagnosis
