#pragma once

#include "app/prove/proof_score.hpp"

namespace railpem::app {

/// How strong each effect has to be, from the trials that hide it alone.
std::vector<Detectability> detectability_of(const std::vector<ScoredTrial>& trials);

}  // namespace railpem::app
