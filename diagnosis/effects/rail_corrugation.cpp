#include "diagnosis/effects/catalogue.hpp"

namespace railpem::diagnosis {

Effect rail_corrugation() {
    return {
        .id = "rail-corrugation",
        .says = "the running surface has waves of nearly one length",
        .equation =
            "adds to S(n) a Gaussian around n = 1/wavelength with relative standard deviation `relative_bandwidth` "
            "whose integral is rms²; the same for all wheels",
        .source = "Grassie & Kalousek 1993, Proc. IMechE F 207; Grassie 2009, Proc. IMechE F 223",
        .parameters = {{.name = "wavelength_m",
                        .unit = "m",
                        .low = 0.02,
                        .high = 3.0,
                        .typical = 0.3,
                        .spread = Spread::logarithmic,
                        .says = "wavelength"},
                       {.name = "relative_bandwidth",
                        .unit = "1",
                        .low = 0.005,
                        .high = 0.5,
                        .typical = 0.05,
                        .spread = Spread::logarithmic,
                        .says = "relative standard deviation of the spatial frequency"},
                       {.name = "rms_m",
                        .unit = "m",
                        .low = 1e-6,
                        .high = 5e-4,
                        .typical = 20e-6,
                        .spread = Spread::logarithmic,
                        .strength = true,
                        .nothing = 0.0,
                        .amplitude = true,
                        .says = "rms amplitude"}},
        .elements = {Element::irregularity},
        .bands = {{10.0, 200.0}},
        .mimics =
            "A resonance (bending of the wheelset, a support) stays at its frequency when the speed changes; a "
            "corrugation stays at its wavelength. An out-of-round wheel shows on one axle box.",
        .obstacle = {},
        .apply =
            [](pem::CaseParameters& parameters, const EffectInstance& effect, const ParameterAccess&) {
                parameters.irregularity.corrugation.push_back(
                    {.wavelength_m = effect.values.at("wavelength_m"),
                     .relative_bandwidth = effect.values.at("relative_bandwidth"),
                     .rms_m = effect.values.at("rms_m")});
            },
    };
}

}  // namespace railpem::diagnosis
