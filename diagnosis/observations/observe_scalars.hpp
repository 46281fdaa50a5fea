#pragma once
// A recording without time series as the likelihood sees it.

#include "diagnosis/observations/observation.hpp"

namespace railpem::diagnosis {

/// Prepares a recording of kind psd, points, receptance or decay-rate. Deviations of the logarithm: 1/√averages or the
/// stated standard error, else 10 % (spectra), 5 % (receptance), 15 % (decay rate). Spectra are cut to where the
/// believed irregularity excites at their speed. One third-octave in four is held out. Throws
/// parameters::ParameterError when no channel is one that the case has, a spectrum has no speed, or no value is left.
Observation observe_scalars(const recordings::Recording& recording, const std::string& name,
                            const pem::CaseParameters& believed, const ObservationOptions& options);

}  // namespace railpem::diagnosis
