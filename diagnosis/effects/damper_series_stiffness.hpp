#pragma once

#include "diagnosis/effects/effect.hpp"
#include "vehicle/vehicle_parameters.hpp"

namespace railpem::diagnosis {

/// The damper of one stage of the suspension acts through a spring, in series with what the case has there already.
EffectInModel damper_series_stiffness(vehicle::SuspensionParameters vehicle::VehicleParameters::*stage);

}  // namespace railpem::diagnosis
