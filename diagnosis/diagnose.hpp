#pragma once
// From a believed case and recordings to a verdict.

#include "diagnosis/findings/diagnosis.hpp"
#include "diagnosis/judge/verdict_thresholds.hpp"
#include "diagnosis/observations/believed_case.hpp"
#include "diagnosis/observations/observation.hpp"
#include "diagnosis/search/naming_options.hpp"

namespace railpem::diagnosis {

struct DiagnoseOptions {
    VerdictThresholds thresholds;
    NamingOptions naming;
    int threads = 0;
    std::function<void(const std::string&, double)> progress;
    std::function<bool()> interrupted;  ///< asked between steps; true ends the search with what is known
};

/// The whole diagnosis: retune, locate, name, verify on what no fit has seen, refit on everything.
Diagnosis diagnose(const BelievedCase& believed, const std::vector<Observation>& observations,
                   const DiagnoseOptions& options);

}  // namespace railpem::diagnosis
