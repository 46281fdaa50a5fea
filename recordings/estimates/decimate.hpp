#pragma once

#include <cstddef>
#include <vector>

namespace railpem::recordings {

/// Largest factor by which a record may be thinned so that everything up to `highest_hz` stays as it was: the rate that
/// is left is at least 2.5 times that. 1: not at all.
std::size_t decimation_factor(double sampling_rate_hz, double highest_hz);

/// Every `factor`-th sample behind a low-pass without delay (Kaiser window, 100 dB from where the new rate folds back
/// onto `highest_hz`; Oppenheim & Schafer 2010, section 7.6). Within half a filter length of the ends the weights are
/// those of the samples that there are. A missing sample (NaN) makes those missing that it would enter.
std::vector<double> decimated(const std::vector<double>& samples, double sampling_rate_hz, std::size_t factor,
                              double highest_hz);

}  // namespace railpem::recordings
