#include "effects/catalogue.hpp"

namespace railpem::effects {

EffectDescription rail_corrugation() {
    return {
        .id = "rail-corrugation",
        .row = 110,
        .says = "the running surface has waves of nearly one length",
        .in_short = "the rail is corrugated",
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
                        .in_short = "of the corrugation",
                        .says = "wavelength"},
                       {.name = "relative_bandwidth",
                        .unit = "1",
                        .low = 0.005,
                        .high = 0.5,
                        .typical = 0.05,
                        .spread = Spread::logarithmic,
                        .in_short = "standard deviation over mean of its spatial frequency",
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
                        .simulated = {.standard = 5e-5},
                        .in_short = "rms height",
                        .says = "rms amplitude"}},
        .elements = {Element::irregularity},
        .bands = {{10.0, 200.0}},
        .mimics =
            "A resonance (bending of the wheelset, a support) stays at its frequency when the speed changes; a "
            "corrugation stays at its wavelength. An out-of-round wheel shows on one axle box.",
        .draws = {{.parameters =
                       {{.name = "wavelength_m", .low = 0.15, .high = 1.0, .spacing = DrawSpacing::logarithmic},
                        {.name = "relative_bandwidth", .low = 0.02, .high = 0.2, .spacing = DrawSpacing::logarithmic},
                        {.name = "rms_m",
                         .low = 1e-5,
                         .high = 2e-4,
                         .spacing = DrawSpacing::logarithmic,
                         .scaled_by = "wavelength_m",
                         .power = 1.0}},
                   .strength = "rms_m",
                   .wavelength = "wavelength_m"}},
    };
}

}  // namespace railpem::effects
