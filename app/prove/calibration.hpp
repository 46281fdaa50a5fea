#pragma once

#include "app/prove/proof_score.hpp"

namespace railpem::app {

/// Sets of effects by the probability that the posterior gave them, and how many of each bin are what is hidden:
/// identifiers only, "unknown" for what is outside the catalogue, the empty set for nulls.
std::vector<CalibrationBin> calibration_curve(const std::vector<ScoredTrial>& trials);

}  // namespace railpem::app
