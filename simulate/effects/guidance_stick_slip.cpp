#include "simulate/effects/hidden_effects.hpp"

namespace railpem::simulate {

void hide_guidance_stick_slip(const HiddenValues& values, HiddenTarget target) {
    target.only_here.guidance_stick_slip = {values.numbers.at("force_n"), values.numbers.at("static_to_kinetic"),
                                            values.numbers.at("stribeck_velocity_m_per_s")};
}

}  // namespace railpem::simulate
