#pragma once
// What a search has found, written up for whoever asked.

#include "diagnosis/diagnosis.hpp"
#include "diagnosis/name.hpp"
#include "diagnosis/verdict.hpp"

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

/// Verdict, names, places, figures and statement, into `result`.
void write_up(const Findings& findings, Diagnosis& result);

}  // namespace railpem::diagnosis
