#include "effects/catalogue.hpp"
#include "effects/choices.hpp"

namespace railpem::effects {

EffectDescription failed_fasteners() {
    return {
        .id = "failed-fasteners",
        .row = 80,
        .list_row = 35,
        .says = "some fasteners carry little or nothing, so the rail sags further over them",
        .in_short = "some fasteners carry nothing",
        .equation =
            "every n-th seat: lines at m·v/(n·spacing) from the deflection under the standing wheels, and what it "
            "makes of the irregularity's forces at the same shifts. With solver.moving the receptance is averaged over "
            "positions (without, wheel 1 stands over a failed seat). Random seats: shot noise with 2p(1 − "
            "p)/spacing·|pulse(κ)|²",
        .source =
            "Zhou & Shen 2013, J. Zhejiang University Science A 14 (trains over failed fasteners); Rice 1944, Bell "
            "System Technical Journal 23 (shot noise)",
        .parameters = {{.name = "fraction",
                        .unit = "1",
                        .low = 0.005,
                        .high = 0.5,
                        .typical = 0.05,
                        .spread = Spread::logarithmic,
                        .strength = true,
                        .nothing = 0.0,
                        .simulated = {.low = 0.01, .standard = 0.0},
                        .in_short = "share of random seats",
                        .says = "share of seats that have failed at random"},
                       {.name = "remaining_stiffness_fraction",
                        .unit = "1",
                        .low = 0.0,
                        .high = 0.9,
                        .typical = 0.1,
                        .strength = true,
                        .nothing = 1.0,
                        .inexact = 0.12,  // 0.3 left of every tenth was 0.332 at three speeds (docs/proof/README.md)
                        .simulated = {.standard = 0.0},
                        .in_short = "what is left there",
                        .says = "what is left of stiffness and damping at a failed seat"}},
        .only_simulated_parameters = {{.name = "seed",
                                       .unit = "1",
                                       .low = 0.0,
                                       .high = 2147483647.0,
                                       .typical = 1.0,
                                       .says = "draws the random seats"}},
        .choices = {{.name = "every",
                     .options = whole_numbers(2, 100),
                     .whole_number = true,
                     .required = false,
                     .replaces = "fraction",
                     .simulated = {.high = 50.0},
                     .in_short = "every n-th seat",
                     .says = "every n-th seat has failed, instead of a random share"}},
        .elements = {Element::pad},
        .bands = {{1.0, 60.0}},
        .mimics =
            "Regular ones look like rail joints or a corrugation whose wavelength is a multiple of the spacing; "
            "joints have lines up to high orders, fasteners only long waves, and their lines follow the wheel load "
            "while a shape of the rail does not. Random ones look like a rougher track of long waves "
            "(irregularity-spectrum); again a second load separates.",
        .draws = {{.parameters = {{.name = "every", .low = 2.0, .high = 20.0, .spacing = DrawSpacing::whole},
                                  {.name = "remaining_stiffness_fraction", .low = 0.0, .high = 0.6}}},
                  {.parameters = {{.name = "fraction", .low = 0.01, .high = 0.3, .spacing = DrawSpacing::logarithmic},
                                  {.name = "remaining_stiffness_fraction", .low = 0.0, .high = 0.6},
                                  {.name = "seed", .low = 1.0, .high = 1e6, .spacing = DrawSpacing::whole}}}},
    };
}

}  // namespace railpem::effects
