#pragma once
// Which further measurement would tell two explanations apart.

#include <string>

#include "diagnosis/hypotheses/naming_result.hpp"

namespace railpem::diagnosis {

/// The measurement, among other speeds and loads with the channels of the first recording, for which the two fitted
/// sets predict the most different cross-spectra: expected divergence in nats per minute, and the minutes until it
/// reaches 10 nats, as a sentence. The nuisances are those of the two fits: both explain what was recorded.
std::string would_separate(const FittedSet& first, const FittedSet& second, const BelievedCase& believed,
                           const std::vector<Observation>& observations);

}  // namespace railpem::diagnosis
