#pragma once
// Levels of scalar recordings against those of trials.

#include "diagnosis/judge/channel_comparison.hpp"

namespace railpem::diagnosis {

/// Appends one comparison per channel of the recording (receptance and decay rate: one in all). Differences are of
/// power in spectra (10 log10), of amplitude in receptances (20 log10) and of the rate itself in decay rates (10
/// log10), averaged over third-octaves.
void compare_scalars(const Stages& stages, const Observation& observation, std::size_t index, Part part,
                     std::vector<ChannelComparison>& channels);

/// Appends every third-octave of every channel with the probability that its levels alone are so far off by chance; the
/// discrepancy of the trial counts as chance. Returns how many there are.
double scalar_mismatches(const Trial& trial, const Predictions& predictions, const Observation& observation,
                         std::size_t index, Part part, std::vector<Mismatch>& found);

}  // namespace railpem::diagnosis
