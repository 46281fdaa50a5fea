#include "simulate/effects/hidden_effects.hpp"
#include "simulate/effects/sensor_of.hpp"

namespace railpem::simulate {

void hide_timing_skew(const HiddenValues& values, HiddenTarget target) {
    sensor_of(target, values).delay_s += values.numbers.at("delay_s");
}

}  // namespace railpem::simulate
