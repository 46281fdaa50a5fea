#include "diagnosis/effects/effect.hpp"

namespace railpem::diagnosis {

EffectInModel rail_corrugation() {
    return {
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
