#include "simulate/effects/hidden_effects.hpp"
#include "simulate/effects/sensor_of.hpp"

namespace railpem::simulate {

void hide_sensor_gain(const HiddenValues& values, HiddenTarget target) {
    sensor_of(target, values).gain *= values.numbers.at("gain");
}

}  // namespace railpem::simulate
