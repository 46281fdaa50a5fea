#pragma once
// Levels of the recordings against those of trials: what a person looks at.

#include <vector>

#include "diagnosis/judge/channel_comparison.hpp"

namespace railpem::diagnosis {

/// PSDs and third-octave level differences of every channel.
std::vector<ChannelComparison> compare_channels(const Stages& stages, const std::vector<Observation>& observations,
                                                Part part);

/// Root mean square of third-octave differences over channels; bands that say nothing (NaN) are left out.
double rms_db(const std::vector<ChannelComparison>& channels, Stage stage);

/// Bands of channels in which a trial differs from the recordings beyond chance, most certain first. Two tests a band:
/// the channel's level (χ²), and the channel given all others, tr of the conditional residual, which sees what levels
/// hide. False alarms are those of all channels, bands and recordings together (Bonferroni).
std::vector<Mismatch> mismatches(const Trial& trial, const Predictions& predictions,
                                 const std::vector<Observation>& observations, Part part);

}  // namespace railpem::diagnosis
