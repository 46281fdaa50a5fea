#pragma once
// What was found, fitted again on all of the recordings.

#include <optional>

#include "diagnosis/judge/verdict.hpp"

namespace railpem::diagnosis {

/// Fits on the fitted and the held-out part together.
struct Refitted {
    FittedSet retuned;
    FittedSet named;                ///< with its robust covariance; the retuned case where nothing is named
    std::optional<FittedSet> kept;  ///< the rival of a verdict of beliefs alone
};

/// Near where the search has left them; `context` is that of the fitted part.
Refitted refit_on_all(const BelievedCase& believed, const LikelihoodContext& context, const NamingResult& naming,
                      const PlaceStudy& study, const Decision& decision);

}  // namespace railpem::diagnosis
