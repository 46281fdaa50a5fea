#pragma once
// Channels whose unit cannot be trusted: their shape says something, their level nothing.

#include <complex>
#include <vector>

#include "diagnosis/observations/observation.hpp"

namespace railpem::diagnosis {

/// Cross-spectral matrices, one after the other, as channels show them whose power is e^{log_gain} of the true one.
/// Without any gain nothing is done.
void scale_channels(const std::vector<double>& log_gain, std::vector<std::complex<double>>& values);

/// Where a fit looks for the scales first: the mean difference, in the logarithm, of recorded and believed power over
/// the band.
void guess_scales(Observation& observation, const pem::CaseParameters& believed);

}  // namespace railpem::diagnosis
