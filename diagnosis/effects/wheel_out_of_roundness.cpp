#include "diagnosis/effects/catalogue.hpp"
#include "diagnosis/effects/choices.hpp"

namespace railpem::diagnosis {

Effect wheel_out_of_roundness() {
    return {
        .id = "wheel-out-of-roundness",
        .says = "a wheel is not round: its radius has a number of waves around the circumference",
        .equation =
            "radius deviation a·cos(nθ + φ): a line at n·v/(2πR) at that wheel only, a source of its own that no "
            "other wheel shares; one instance per wheel and order",
        .source = "Nielsen & Johansson 2000, Proc. IMechE F 214",
        .parameters = {{.name = "amplitude_m",
                        .unit = "m",
                        .low = 1e-6,
                        .high = 1e-3,
                        .typical = 50e-6,
                        .spread = Spread::logarithmic,
                        .strength = true,
                        .nothing = 0.0,
                        .amplitude = true,
                        .says = "amplitude of the radius deviation"}},
        .choices = {{.name = "wheel",
                     .options = whole_numbers(1, 4),
                     .whole_number = true,
                     .says = "the wheel, counted from the front"},
                    {.name = "order",
                     .options = whole_numbers(1, 60),
                     .whole_number = true,
                     .says = "number of waves around the circumference"}},
        .elements = {Element::wheel},
        .bands = {{5.0, 200.0}},
        .mimics =
            "A corrugation whose wavelength is a fraction of the circumference: that is met by all wheels one after "
            "the other, this by one. The coherence between axle boxes at the line, and the exact order of "
            "rotation, decide.",
        .excites = true,
        .lines_alone = true,
        .obstacle = {},
        .apply =
            [](pem::CaseParameters& parameters, const EffectInstance& effect, const ParameterAccess&) {
                parameters.wheel_out_of_roundness.push_back({.wheel = std::stoi(effect.choices.at("wheel")),
                                                             .order = std::stoi(effect.choices.at("order")),
                                                             .amplitude_m = effect.values.at("amplitude_m")});
            },
    };
}

}  // namespace railpem::diagnosis
