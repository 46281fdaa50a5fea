#pragma once
// The further run that would tell whether friction is constant.

#include <string>

#include "diagnosis/judge/friction_law.hpp"

namespace railpem::diagnosis {

/// How well the power of friction's own forces would be known (FrictionLaw::deviation) with one more run of a minute,
/// drawn as if the fit's case were true, all channels as in the first recording of a vehicle. Throws
/// parameters::ParameterError where no band is left at that speed.
double deviation_with_run(const Fit& fit, double speed_m_per_s, const LikelihoodContext& context);

/// In words, a test of the part where no run is to be had: the run, at the speeds of the recordings or 0.6 or 1.5 times
/// the first of them, after which it would be known best.
std::string would_tell_friction(const Fit& fit, const LikelihoodContext& context);

}  // namespace railpem::diagnosis
