#pragma once
// Recordings of wheels that come near to leaving the rail.

#include <string>
#include <vector>

#include "diagnosis/trial.hpp"

namespace railpem::diagnosis {

/// In words, of every time series of a vehicle in which the contact forces of `trial` vary by more than a quarter of the static load (rms): there a wheel leaves the rail now and then, the expectation goes to second order
/// in the contact only, and what a diagnosis misses may be that.
std::vector<std::string> wheel_unloading(const Trial& trial, const BelievedCase& believed, const std::vector<Observation>& observations);

}  // namespace railpem::diagnosis
