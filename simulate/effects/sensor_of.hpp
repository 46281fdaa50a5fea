#pragma once

#include "simulate/effects/hidden_effects.hpp"

namespace railpem::simulate {

/// The sensor of the channel that `values` state; a new one where the case has none.
pem::SensorParameters& sensor_of(HiddenTarget target, const HiddenValues& values);

}  // namespace railpem::simulate
