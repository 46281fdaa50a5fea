#include "diagnosis/effects/catalogue.hpp"

namespace railpem::diagnosis {

Effect pad_hysteresis() {
    return {
        .id = "pad-hysteresis",
        .says =
            "the pad dissipates the same share of its energy at every frequency (a loss factor) instead of like a "
            "dashpot",
        .equation =
            "K(f) = K_const (f/30 Hz)^((2/π) atan η) (1 + iη), the causal law of a flat loss factor; it replaces "
            "the dashpot, so there is no strength at which it fades into the case",
        .source = "Thompson & Verheij 1997, Applied Acoustics 52",
        .parameters = {{.name = "loss_factor",
                        .unit = "1",
                        .low = 0.05,
                        .high = 1.0,
                        .typical = 0.25,
                        .spread = Spread::logarithmic,
                        .inexact = 0.003,  // scripts/interval_misses.py
                        .says = "the loss factor η: imaginary over real part of the stiffness"}},
        .elements = {Element::pad},
        .bands = {{30.0, 200.0}},
        .mimics =
            "Another dashpot (parameter-error of track.pads.damping_n_s_per_m) with the same loss at the wheel's "
            "resonance; they part below and above it: the dashpot's loss grows with frequency, this one does not. "
            "pad-frequency-stiffening keeps the dashpot.",
        .replaces = true,
        .obstacle = [](const pem::CaseParameters& parameters) -> std::optional<Obstacle> {
            const track::PadParameters& pads = parameters.track.pads;
            if (!pads.table_frequency_hz.empty())
                return Obstacle{"the case has a measured pad modulus, which already says how the pad dissipates",
                                "a case without track.pads.table_frequency_hz"};
            if (pads.loss_factor > 0.0)
                return Obstacle{"the pads of the case have a loss factor already",
                                "a case with track.pads.loss_factor = 0; another value of it is a parameter-error"};
            return std::nullopt;
        },
        .apply =
            [](pem::CaseParameters& parameters, const EffectInstance& effect, const ParameterAccess&) {
                parameters.track.pads.loss_factor = effect.values.at("loss_factor");
                parameters.track.pads.loss_law = track::LossLaw::causal;
                parameters.track.pads.loss_reference_hz = 30.0;
            },
    };
}

}  // namespace railpem::diagnosis
