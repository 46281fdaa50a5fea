#pragma once
// Judges the trials and counts them.

#include <vector>

#include "app/prove/proof_score.hpp"

namespace railpem::app {

/// Judges every finished trial. `truths` and `results` are those of the same trials in the same order.
std::vector<ScoredTrial> judge_all(const std::vector<TrialTruth>& truths, const std::vector<TrialResult>& results);

ProofScore score_of(const std::vector<ScoredTrial>& trials);

}  // namespace railpem::app
