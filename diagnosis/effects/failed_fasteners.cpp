#include "diagnosis/effects/catalogue.hpp"
#include "diagnosis/effects/choices.hpp"

namespace railpem::diagnosis {

Effect failed_fasteners() {
    return {
        .id = "failed-fasteners",
        .says = "some fasteners carry little or nothing, so the rail sags further over them",
        .equation =
            "every n-th seat: lines at m·v/(n·spacing) from the deflection under the standing wheels, what it "
            "makes of the irregularity's forces at the same shifts, and with solver.moving a receptance averaged "
            "over positions (without, wheel 1 stands over a failed seat); random "
            "seats: shot noise with 2p(1 − p)/spacing·|pulse(κ)|²",
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
                        .says = "share of seats that have failed at random"},
                       {.name = "remaining_stiffness_fraction",
                        .unit = "1",
                        .low = 0.0,
                        .high = 0.9,
                        .typical = 0.1,
                        .strength = true,
                        .nothing = 1.0,
                        .inexact = 0.12,  // 0.3 left of every tenth was 0.332 at three speeds (docs/proof/README.md)
                        .says = "what is left of stiffness and damping at a failed seat"}},
        .choices = {{.name = "every",
                     .options = whole_numbers(2, 100),
                     .whole_number = true,
                     .required = false,
                     .replaces = "fraction",
                     .says = "every n-th seat has failed, instead of a random share"}},
        .elements = {Element::pad},
        .bands = {{1.0, 60.0}},
        .mimics =
            "Regular ones look like rail joints or a corrugation whose wavelength is a multiple of the spacing; "
            "joints have lines up to high orders, fasteners only long waves, and their lines follow the wheel load "
            "while a shape of the rail does not. Random ones look like a rougher track of long waves "
            "(irregularity-spectrum); again a second load separates.",
        .abrupt = true,
        // what swings between a failed seat and the next is as if the wheels stood everywhere; of seats at random to
        // first order
        .approximate = true,
        // rails 0.8 times as heavy, contacts twice as soft: 4.8 to 10.8 tolerances beside five right ones before what
        // regular ones scatter was expected, 12.9 and more beside plays of the fastenings
        .bends_numbers = 11.0,
        .obstacle = [](const pem::CaseParameters& parameters) -> std::optional<Obstacle> {
            if (parameters.track.failed_fasteners.empty()) return std::nullopt;
            return Obstacle{"the case has failed fasteners already", "a case without [[track.failed_fasteners]]"};
        },
        .apply =
            [](pem::CaseParameters& parameters, const EffectInstance& effect, const ParameterAccess&) {
                const auto every = effect.choices.find("every");
                track::FailedFasteners failed;
                failed.remaining_stiffness_fraction = effect.values.at("remaining_stiffness_fraction");
                if (every != effect.choices.end())
                    failed.every = std::stoi(every->second);
                else
                    failed.fraction = effect.values.at("fraction");
                parameters.track.failed_fasteners.push_back(failed);
            },
    };
}

}  // namespace railpem::diagnosis
