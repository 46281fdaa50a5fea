#pragma once
// A time series as the likelihood sees it.

#include <string>

#include "diagnosis/observations/observation.hpp"
#include "recordings/recording.hpp"

namespace railpem::diagnosis {

/// Prepares a time series. The band is cut to where the believed irregularity excites at this speed.
/// Throws parameters::ParameterError when no channel is one that the case has, more than kMostChannels are, or no
/// usable band is left.
Observation observe(const recordings::Recording& recording, const std::string& name,
                    const pem::CaseParameters& believed, const ObservationOptions& options);

}  // namespace railpem::diagnosis
