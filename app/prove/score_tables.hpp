#pragma once

#include <string>
#include <vector>

#include "app/prove/proof_score.hpp"

namespace railpem::app {

/// trials.csv: a row per finished trial, what was hidden beside what was said.
std::string trials_csv(const std::vector<ScoredTrial>& trials);

/// score.json. `settings` is the JSON of proof.json; `asked`: trials of the proof, finished or not; `seed` of the
/// proof.
std::string score_json(const ProofScore& score, const std::vector<ScoredTrial>& trials, const std::string& settings,
                       std::size_t asked);

/// The measures as lines for a terminal.
std::string score_lines(const ProofScore& score);

}  // namespace railpem::app
