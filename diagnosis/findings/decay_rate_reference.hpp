#pragma once
// Decay rates of a track held against what it had when the case was fitted to it.

#include <vector>

#include "diagnosis/likelihood/likelihood.hpp"
#include "pem/case_parameters.hpp"

namespace railpem::diagnosis {

/// The reference that a later diagnosis starts from: ratios of the recorded decay rates to what `predictions` say
/// without any, geometric means over all recordings of them, with the standard error of that mean. That of `trial`
/// itself where none of the observations is a decay rate.
pem::DecayRateReference decay_rate_reference(const Trial& trial, const Predictions& predictions,
                                             const std::vector<Observation>& observations);

}  // namespace railpem::diagnosis
