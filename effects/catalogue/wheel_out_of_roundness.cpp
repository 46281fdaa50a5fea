#include "effects/catalogue.hpp"
#include "effects/choices.hpp"

namespace railpem::effects {

EffectDescription wheel_out_of_roundness() {
    return {
        .id = "wheel-out-of-roundness",
        .row = 100,
        .list_row = 135,
        .says = "a wheel is not round: its radius has a number of waves around the circumference",
        .in_short = "a wheel is not round",
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
                        .simulated = {.standard = 1e-4},
                        .in_short = "of the radius",
                        .says = "amplitude of the radius deviation"}},
        .choices = {{.name = "wheel",
                     .options = whole_numbers(1, 4),
                     .whole_number = true,
                     .in_short = "from the front",
                     .says = "the wheel, counted from the front"},
                    {.name = "order",
                     .options = whole_numbers(1, 60),
                     .whole_number = true,
                     .simulated = {.standard = 3.0},
                     .in_short = "waves around it",
                     .says = "number of waves around the circumference"}},
        .elements = {Element::wheel},
        .bands = {{5.0, 200.0}},
        .mimics =
            "A corrugation whose wavelength is a fraction of the circumference: that is met by all wheels one after "
            "the other, this by one. The coherence between axle boxes at the line, and the exact order of "
            "rotation, decide.",
        // The higher the order, the less of it is needed for the same acceleration.
        .draws = {{.parameters = {{.name = "wheel", .low = 1.0, .high = 4.0, .spacing = DrawSpacing::whole},
                                  {.name = "order", .low = 1.0, .high = 20.0, .spacing = DrawSpacing::whole},
                                  {.name = "amplitude_m",
                                   .low = 1e-5,
                                   .high = 6e-4,
                                   .spacing = DrawSpacing::logarithmic,
                                   .scaled_by = "order",
                                   .power = -1.0}},
                   .strength = "amplitude_m",
                   .waves_per_turn = "order"}},
    };
}

}  // namespace railpem::effects
