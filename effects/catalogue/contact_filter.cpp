#include "effects/catalogue.hpp"

namespace railpem::effects {

EffectDescription contact_filter() {
    return {
        .id = "contact-filter",
        .row = 210,
        .says = "the contact patch has a length and averages waves of the rail that are short beside it",
        .in_short = "the contact patch averages short waves",
        .equation = "amplitude of waves of wavenumber κ × (1 + π/4·(κa)³)^(−1/2)",
        .source = "Remington 1987, J. Acoust. Soc. Am. 81",
        .parameters = {{.name = "patch_half_length_m",
                        .unit = "m",
                        .low = 0.003,
                        .high = 0.009,
                        .typical = 0.006,
                        .strength = true,
                        .nothing = 0.0,
                        .in_short = "half length of the patch",
                        .says = "half length a of the patch along the rail"}},
        .elements = {Element::contact},
        .bands = {{150.0, 500.0}},
        .mimics =
            "A track that is smoother at short waves (irregularity-spectrum with a slope): over the wavelengths that "
            "a train can feel they differ by the cubic bend only. A measured roughness decides.",
        .draws = {{.parameters = {{.name = "patch_half_length_m", .low = 0.003, .high = 0.009}},
                   .strength = "patch_half_length_m"}},
    };
}

}  // namespace railpem::effects
