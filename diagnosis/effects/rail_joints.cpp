#include "diagnosis/effects/effect.hpp"

namespace railpem::diagnosis {

EffectInModel rail_joints() {
    return {
        .lines_alone = true,
        .needs_lines = true,
        .apply =
            [](pem::CaseParameters& parameters, const EffectInstance& effect, const ParameterAccess&) {
                parameters.irregularity.joints.push_back({.spacing_m = effect.values.at("spacing_m"),
                                                          .depth_m = effect.values.at("depth_m"),
                                                          .length_m = effect.values.at("length_m")});
            },
    };
}

}  // namespace railpem::diagnosis
