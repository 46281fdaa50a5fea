#pragma once
// What tuned masses on the rail add to its mass.

#include <complex>
#include <vector>

#include "track/rail_parameters.hpp"

namespace railpem::track {

/// Sum of the dynamic masses of all lines of dampers, kg per metre of rail, at f > 0 Hz; see RailDamper.
std::complex<double> damper_mass_kg_per_m(const std::vector<RailDamper>& dampers, double frequency_hz);

}  // namespace railpem::track
