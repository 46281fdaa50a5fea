#include "simulate/effects/hidden_effects.hpp"

namespace railpem::simulate {

void hide_body_coupling(const HiddenValues& values, HiddenTarget target) {
    target.only_here.body_coupling = {
        values.numbers.at("stiffness_n_per_m"),       values.numbers.at("damping_n_s_per_m"),
        values.numbers.at("neighbour_mass_kg"),       values.numbers.at("neighbour_frequency_hz"),
        values.numbers.at("neighbour_damping_ratio"), values.numbers.at("position_m")};
}

}  // namespace railpem::simulate
