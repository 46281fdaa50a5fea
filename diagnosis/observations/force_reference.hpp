#pragma once
// What the forces that arise in a suspension by itself are measured against.

#include <vector>

#include "diagnosis/observations/observation.hpp"

namespace railpem::diagnosis {

/// Reference of forces of a suspension's own in a recording: what shakes a ton as the recorded bogies shake (without
/// them all channels of the vehicle), N²/Hz, at `nodes`; of the part that fits see.
std::vector<double> force_reference(const Observation& observation, const std::vector<double>& nodes);

}  // namespace railpem::diagnosis
