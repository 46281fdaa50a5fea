#pragma once

#include "diagnosis/hypotheses/naming_result.hpp"
#include "diagnosis/judge/verdict.hpp"

namespace railpem::diagnosis {

/// Everything that a diagnosis rests on; all of it has to outlive this.
struct Findings {
    const BelievedCase& believed;
    const std::vector<Observation>& observations;
    const LikelihoodContext& context;  ///< of the fitted part
    const VerdictThresholds& thresholds;
    const NamingResult& naming;
    const PlaceStudy& study;
    const Decision& decision;
    const FittedSet& retuned;  ///< refitted on all of the recordings
    /// that too, with the beliefs kept that are given up; nullptr where the verdict is held against `retuned`
    const FittedSet* kept;
    const FittedSet& named;  ///< that too; `retuned` where nothing is named
};

}  // namespace railpem::diagnosis
