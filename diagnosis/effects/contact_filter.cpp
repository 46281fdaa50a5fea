#include "diagnosis/effects/catalogue.hpp"

namespace railpem::diagnosis {

Effect contact_filter() {
    return {
        .id = "contact-filter",
        .says = "the contact patch has a length and averages waves of the rail that are short beside it",
        .equation = "amplitude of waves of wavenumber κ × (1 + π/4·(κa)³)^(−1/2)",
        .source = "Remington 1987, J. Acoust. Soc. Am. 81",
        .parameters = {{.name = "patch_half_length_m",
                        .unit = "m",
                        .low = 0.003,
                        .high = 0.009,
                        .typical = 0.006,
                        .strength = true,
                        .nothing = 0.0,
                        .says = "half length a of the patch along the rail"}},
        .elements = {Element::contact},
        .bands = {{150.0, 500.0}},
        .mimics =
            "A track that is smoother at short waves (irregularity-spectrum with a slope): over the wavelengths that "
            "a train can feel they differ by the cubic bend only. A measured roughness decides.",
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
