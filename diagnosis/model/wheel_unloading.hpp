#pragma once
// Recordings of wheels that come near to leaving the rail.

#include <string>
#include <vector>

#include "diagnosis/model/trial.hpp"

namespace railpem::diagnosis {

/// In words, of every time series of a vehicle in which the contact forces of `trial` vary by more than 22 % of the
/// static load (rms): there a wheel leaves the rail now and then, the expectation goes to second order in the contact
/// only, and what a diagnosis misses may be that.
std::vector<std::string> wheel_unloading(const Trial& trial, const BelievedCase& believed,
                                         const std::vector<Observation>& observations);

/// Takes out the time series in which, by the power that its wheels recorded, the contact forces vary by more than 22 %
/// of the static load (rms): a wheel leaves the rail now and then, and what it does then looks like other physics (9 dB
/// of roughness at 39 m/s were `explained` by preloaded pads, joints were `unexplained` at 0.26 of it). None where no
/// other recording of the vehicle is left. What was taken out, in words.
std::vector<std::string> leave_out_unloaded(std::vector<Observation>& observations);

}  // namespace railpem::diagnosis
