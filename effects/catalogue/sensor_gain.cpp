#include "effects/catalogue.hpp"
#include "effects/choices.hpp"

namespace railpem::effects {

EffectDescription sensor_gain() {
    return {
        .id = "sensor-gain",
        .row = 220,
        .says = "a channel reads too high or too low, or is inverted",
        .equation = "channel × gain: one row and one column of the cross-spectral matrix",
        .source = "ISO 16063-21 (calibration of vibration transducers by comparison)",
        .parameters = {{.name = "gain",
                        .unit = "1",
                        .low = -10.0,
                        .high = 10.0,
                        .typical = 1.15,
                        .strength = true,
                        .nothing = 1.0,
                        .least = 1e-3,  // ISO 16063-21: the best calibrations are sure of half a per cent
                        .simulated = {.standard = 1.1},
                        .in_short = "negative: inverted",
                        .says = "what the channel reads over what is there; negative: inverted"}},
        .choices = {channel_choice()},
        .elements = {Element::sensor},
        .bands = {{0.3, 500.0}},
        .mimics =
            "No physics of the train scales one channel at all frequencies alike and leaves the others alone; a wrong "
            "mass or spring changes its neighbours and goes with frequency. An inverted channel has the right "
            "spectrum: only cross-spectra show it.",
        .draws = {{.parameters = {{.name = "gain",
                                   .low = 0.01,
                                   .high = 0.5,
                                   .spacing = DrawSpacing::logarithmic,
                                   .mirror = DrawMirror::sign,
                                   .offset = 1.0,
                                   .upside_down = 0.1}},
                   .strength = "gain"}},
    };
}

}  // namespace railpem::effects
