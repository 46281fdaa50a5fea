#include "diagnosis/effects/effect.hpp"

namespace railpem::diagnosis {

EffectInModel pad_hysteresis() {
    return {
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
