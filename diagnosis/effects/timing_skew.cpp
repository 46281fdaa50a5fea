#include "diagnosis/effects/catalogue.hpp"
#include "diagnosis/effects/choices.hpp"
#include "diagnosis/effects/sensor_chain_entries.hpp"

namespace railpem::diagnosis {

Effect timing_skew() {
    return {
        .id = "timing-skew",
        .says = "a channel is shifted in time against the others",
        .equation = "channel × e^(−iωτ): phase linear in frequency, and the same τ at every speed",
        .source = "Bendat & Piersol 2010, Random Data, ch. 5 (time delays in cross-spectra)",
        .parameters = {{.name = "delay_s",
                        .unit = "s",
                        .low = -1.0,
                        .high = 1.0,
                        .typical = 2e-3,
                        .strength = true,
                        .nothing = 0.0,
                        .least = 1e-5,  // a hundredth of a sample at 1 kHz
                        .says = "the channel is late by this time"}},
        .choices = {{.name = "channel", .options = channel_names(), .says = "the channel"}},
        .elements = {Element::sensor},
        .bands = {{0.3, 500.0}},
        .mimics =
            "A wrong position or wheelbase, or a wrong speed: their delays scale with 1/v. No spectrum of a single "
            "channel shows it.",
        .obstacle = {},
        .apply =
            [](pem::CaseParameters& parameters, const EffectInstance& effect, const ParameterAccess&) {
                first_entry(parameters, effect.choices.at("channel")).delay_s += effect.values.at("delay_s");
            },
    };
}

}  // namespace railpem::diagnosis
