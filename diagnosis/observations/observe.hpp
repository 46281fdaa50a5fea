#pragma once
// A time series as the likelihood sees it.

#include <string>
#include <vector>

#include "diagnosis/observations/observation.hpp"
#include "recordings/recording.hpp"

namespace railpem::diagnosis {

/// Prepares a time series. The band is cut to where the believed irregularity excites at this speed. A record whose
/// speed changes by more than ObservationSettings::widest_speed_range is observed in pieces, each at its own speeds and
/// called after its times; else it is one observation.
/// Throws parameters::ParameterError when no channel is one that the case has, more than kMostChannels are, or no
/// usable band is left.
std::vector<Observation> observe(const recordings::Recording& recording, const std::string& name,
                                 const pem::CaseParameters& believed, const ObservationOptions& options);

}  // namespace railpem::diagnosis
