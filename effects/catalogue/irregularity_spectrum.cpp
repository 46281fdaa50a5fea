#include "effects/catalogue.hpp"

namespace railpem::effects {

EffectDescription irregularity_spectrum() {
    return {
        .id = "irregularity-spectrum",
        .row = 130,
        .says =
            "the track is rougher or smoother than believed, or its roughness is spread differently over the "
            "wavelengths",
        .in_short = "the track is rougher, smoother or differently shaped than believed",
        .equation = "S(n) × 10^(level/10)·(λ/3 m)^(slope/(10·log10 2)); adds to the case's own level and slope",
        .source = "Hamid & Yang 1981, Transportation Research Record 838 (spread between tracks and classes)",
        .parameters = {{.name = "level_db",
                        .unit = "dB",
                        .low = -20.0,
                        .high = 20.0,
                        .typical = 4.0,
                        .strength = true,
                        .nothing = 0.0,
                        .simulated = {.standard = 0.0},
                        .in_short = "at a wavelength of 3 m",
                        .says = "level at a wavelength of 3 m"},
                       {.name = "slope_db_per_octave",
                        .unit = "dB",
                        .low = -6.0,
                        .high = 6.0,
                        .typical = 1.0,
                        .strength = true,
                        .nothing = 0.0,
                        .simulated = {.standard = 0.0},
                        .in_short = "per octave of wavelength",
                        .says = "change per octave of wavelength, positive: long waves stronger"}},
        .elements = {Element::irregularity},
        .bands = {{0.3, 200.0}},
        .mimics =
            "A gain that is wrong on all channels alike, and any effect below the wheels at one speed: all of them "
            "multiply every channel by one common factor. Over several speeds irregularity stays at its wavelength "
            "and structure at its frequency; a measured irregularity decides.",
        .draws = {{.parameters = {{.name = "level_db",
                                   .low = 2.0,
                                   .high = 12.0,
                                   .spacing = DrawSpacing::logarithmic,
                                   .mirror = DrawMirror::sign},
                                  {.name = "slope_db_per_octave", .low = -1.5, .high = 1.5}},
                   .strength = "level_db"}},
    };
}

}  // namespace railpem::effects
