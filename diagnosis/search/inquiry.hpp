#pragma once

#include <functional>
#include <string>
#include <vector>

#include "diagnosis/judge/verdict_thresholds.hpp"
#include "diagnosis/likelihood/likelihood_context.hpp"
#include "diagnosis/observations/believed_case.hpp"
#include "diagnosis/observations/observation.hpp"
#include "diagnosis/search/naming_options.hpp"

namespace railpem::diagnosis {

/// What every step from the search to the verdict works with; all of it has to outlive this.
struct Inquiry {
    const BelievedCase& believed;
    const std::vector<Observation>& observations;
    const LikelihoodContext& context;  ///< of the fitted part
    const NamingOptions& naming;
    const VerdictThresholds& thresholds;
    std::function<void(const std::string& what, double share)> say;  ///< what is being done, share done
};

}  // namespace railpem::diagnosis
