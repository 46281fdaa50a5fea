#pragma once

#include <string>

#include "diagnosis/effects/effect.hpp"
#include "vehicle/vehicle_parameters.hpp"

namespace railpem::diagnosis {

/// The effect of a damper that acts through a spring, in one stage of the suspension. What both stages share: law,
/// source and how it is switched on.
struct DamperSeriesStiffness {
    std::string id;
    std::string stage;  ///< "primary" or "secondary", for the texts
    vehicle::SuspensionParameters vehicle::VehicleParameters::*suspension;
    Element element;
    double low_n_per_m;
    double high_n_per_m;
    double typical_n_per_m;
    Band band;
    std::string mimics;
};

Effect damper_series_stiffness(const DamperSeriesStiffness& stage);

}  // namespace railpem::diagnosis
