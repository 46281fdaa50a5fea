#include "diagnosis/effects/catalogue.hpp"

namespace railpem::diagnosis {

Effect sleeper_passing() {
    return {
        .id = "sleeper-passing",
        .says = "the wheels feel the supports passing under them more than the believed track explains",
        .equation =
            "lines at n·v/spacing with the wheels' delays; amplitude = factor × own × the difference of the "
            "deflection under the standing load over and between the pads, own = the case's amplitude_factor, or 1 "
            "when the case does not model it",
        .source = "Wu & Thompson 2004, J. Sound Vib. 278; Nordborg 1998, Acustica united with Acta Acustica 84",
        .parameters = {{.name = "amplitude_factor",
                        .unit = "1",
                        .low = 1.0,
                        .high = 20.0,
                        .typical = 3.0,
                        .spread = Spread::logarithmic,
                        .strength = true,
                        .nothing = 1.0,
                        .says = "amplitude over that of the case's own compliance; 1 is no excess"}},
        .elements = {Element::irregularity},
        .bands = {{20.0, 150.0}},
        .mimics =
            "A corrugation of the support spacing. rail-shear also raises the line (fourfold on the track of Wei et "
            "al. 2016), without raising its harmonics alike. A second load moves this line in proportion; a second "
            "speed moves both.",
        .lines_alone = true,
        .retuned = true,
        .obstacle = {},
        .apply =
            [](pem::CaseParameters& parameters, const EffectInstance& effect, const ParameterAccess&) {
                double& own = parameters.sleeper_passing.amplitude_factor;
                own = (own == 0.0 ? 1.0 : own) * effect.values.at("amplitude_factor");
            },
    };
}

}  // namespace railpem::diagnosis
