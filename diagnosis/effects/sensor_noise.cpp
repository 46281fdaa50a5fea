#include "diagnosis/effects/catalogue.hpp"
#include "diagnosis/effects/choices.hpp"
#include "diagnosis/effects/sensor_chain_entries.hpp"

namespace railpem::diagnosis {

Effect sensor_noise() {
    return {
        .id = "sensor-noise",
        .says = "a channel carries noise, drift or 1/f noise that has nothing to do with the train",
        .equation =
            "adds S(f) ∝ f^(slope/(10·log10 2)) with an integral of rms² from 0.5 to 500 Hz to one element of the "
            "diagonal of the cross-spectral matrix",
        .source = "Bendat & Piersol 2010, Random Data, ch. 6 (extraneous noise)",
        .parameters = {{.name = "rms_m_per_s2",
                        .unit = "m/s^2",
                        .low = 1e-6,
                        .high = 100.0,
                        .typical = 0.1,
                        .spread = Spread::logarithmic,
                        .strength = true,
                        .nothing = 0.0,
                        .amplitude = true,
                        .says = "rms of the noise, 0.5 to 500 Hz"},
                       {.name = "slope_db_per_octave",
                        .unit = "dB",
                        .low = -12.0,
                        .high = 6.0,
                        .typical = -3.0,
                        .inexact = 0.03,  // scripts/interval_misses.py
                        .says = "slope of its spectrum; −3: 1/f, −6: drift like a random walk"}},
        .choices = {{.name = "channel", .options = channel_names(), .says = "the channel"}},
        .elements = {Element::sensor},
        .bands = {{0.3, 500.0}},
        .mimics = "More vibration at that place: but that is coherent with the other channels, noise is not.",
        .obstacle = {},
        .apply =
            [](pem::CaseParameters& parameters, const EffectInstance& effect, const ParameterAccess&) {
                pem::SensorParameters& sensor = noise_entry(parameters, effect.choices.at("channel"));
                sensor.noise_rms_m_per_s2 = effect.values.at("rms_m_per_s2");
                sensor.noise_slope_db_per_octave = effect.values.at("slope_db_per_octave");
            },
    };
}

}  // namespace railpem::diagnosis
