#pragma once
// Decay rates of a track held against what it had when the case was fitted to it.

#include <vector>

#include "diagnosis/likelihood.hpp"
#include "pem/case_parameters.hpp"

namespace railpem::diagnosis {

/// Element of the reference at a third-octave, or −1.
int reference_band(const pem::DecayRateReference& reference, double frequency_hz);

/// The reference that a later diagnosis starts from: ratios of the recorded decay rates to what `predictions` say
/// without any, geometric means over all recordings of them, with the standard error of that mean. That of `trial`
/// itself where none of the observations is a decay rate.
pem::DecayRateReference decay_rate_reference(const Trial& trial, const Predictions& predictions,
                                             const std::vector<Observation>& observations);

}  // namespace railpem::diagnosis
