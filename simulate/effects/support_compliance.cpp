#include "simulate/effects/hidden_effects.hpp"

namespace railpem::simulate {

void hide_support_compliance(const HiddenValues& values, HiddenTarget target) {
    track::SupportParameters& support = target.parameters.track.support;
    support.model = track::SupportModel::two_layer;
    support.mass_kg = values.numbers.at("mass_kg");
    support.stiffness_n_per_m = values.numbers.at("stiffness_n_per_m");
    support.damping_n_s_per_m = values.numbers.at("damping_n_s_per_m");
}

}  // namespace railpem::simulate
