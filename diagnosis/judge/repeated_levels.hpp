#pragma once
// By how much levels are off, chance left out.

#include <vector>

#include "diagnosis/fit/fit.hpp"

namespace railpem::diagnosis {

/// Root of the mean product of the third-octave differences (dB, recording over fit) of the fitted and of the unseen
/// part, over all channels and bands of time series in which both say something: what chance makes of either part, more
/// where records are short, is not repeated by the other. 0 where they differ with opposite signs, and without any time
/// series.
double repeated_level_db(const Fit& fit, const LikelihoodContext& context);

}  // namespace railpem::diagnosis
