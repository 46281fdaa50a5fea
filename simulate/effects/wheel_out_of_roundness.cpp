#include "simulate/effects/hidden_effects.hpp"

namespace railpem::simulate {

void hide_wheel_out_of_roundness(const HiddenValues& values, HiddenTarget target) {
    target.parameters.wheel_out_of_roundness.push_back({static_cast<int>(values.numbers.at("wheel")),
                                                        static_cast<int>(values.numbers.at("order")),
                                                        values.numbers.at("amplitude_m")});
}

}  // namespace railpem::simulate
