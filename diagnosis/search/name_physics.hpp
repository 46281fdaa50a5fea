#pragma once
// The search for the set of effects that was left out.

#include "diagnosis/hypotheses/naming_result.hpp"
#include "diagnosis/search/naming_options.hpp"

namespace railpem::diagnosis {

/// Retunes, screens, refits, adds and swaps. `context.part` should be the fitted part.
NamingResult name_physics(const BelievedCase& believed, const LikelihoodContext& context, const NamingOptions& options);

}  // namespace railpem::diagnosis
