#include "diagnosis/effects/catalogue.hpp"
#include "diagnosis/effects/choices.hpp"
#include "diagnosis/effects/sensor_chain_entries.hpp"

namespace railpem::diagnosis {

Effect sensor_gain() {
    return {
        .id = "sensor-gain",
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
                        .says = "what the channel reads over what is there; negative: inverted"}},
        .choices = {{.name = "channel", .options = channel_names(), .says = "the channel"}},
        .elements = {Element::sensor},
        .bands = {{0.3, 500.0}},
        .mimics =
            "No physics of the train scales one channel at all frequencies alike and leaves the others alone; a wrong "
            "mass or spring changes its neighbours and goes with frequency. An inverted channel has the right "
            "spectrum: only cross-spectra show it.",
        .obstacle = {},
        .apply =
            [](pem::CaseParameters& parameters, const EffectInstance& effect, const ParameterAccess&) {
                first_entry(parameters, effect.choices.at("channel")).gain *= effect.values.at("gain");
            },
    };
}

}  // namespace railpem::diagnosis
