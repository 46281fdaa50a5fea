#pragma once
// The sets beside the named one, or those that cannot be told apart, and what would decide.

#include "diagnosis/findings/diagnosis.hpp"
#include "diagnosis/findings/findings.hpp"

namespace railpem::diagnosis {

/// Where the verdict is `ambiguous` every credible set, else those that were not named; the best first, six at most.
/// Friction that may be of another law has that as a rival: "unknown" in its place.
std::vector<Rival> rivals_of(const Findings& findings);

}  // namespace railpem::diagnosis
