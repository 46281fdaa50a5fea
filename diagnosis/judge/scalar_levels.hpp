#pragma once
// By how much the levels of recordings without time series are off, beyond what their errors allow.

#include "diagnosis/fit/fit.hpp"

namespace railpem::diagnosis {

/// Root of the mean over channels and third-octaves of d² − σ², in dB, of all values that were recorded: d the mean
/// difference of recording and fit in the band (where phases are known, of level and phase together, a radian counting
/// as a neper), σ its standard error by the stated errors of the values, or the default ones, and the default
/// discrepancy of the model. What a fit gives for discrepancy does not count: it would excuse any difference. 0 where
/// the differences are smaller than the errors, and without such recordings.
double scalar_level_db(const Fit& fit, const LikelihoodContext& context);

}  // namespace railpem::diagnosis
