#pragma once
// The rival of what only gives up a belief: the case that keeps it.

#include "diagnosis/fitted_set.hpp"

namespace railpem::diagnosis {

/// Tolerances within which whoever believes a number retunes it: it ends further away by chance once in twenty cases. RetunedNumber::outside begins there.
inline constexpr double kKeptTolerances = 2.0;

/// The bounds of an unknown that somebody has believed (a number of the case, the irregularity, the passing of supports, a speed) at `kKeptTolerances`, where they are further; any other unknown as it is.
Unknown kept(Unknown unknown);

/// The case refitted with every belief kept, near a `retuned` one. That one weighs its beliefs and may leave them for what they cost: from a set that only gives one up (a number eight tolerances off, a track 8 dB smoother) it
/// then differs by nothing but the cost, and predicts as well what no fit has seen. Whether the belief was wrong is told by the case that keeps it. No members, no prior.
FittedSet fit_within_tolerances(const BelievedCase& believed, const Fit& retuned, const LikelihoodContext& context, const FitOptions& options);

}  // namespace railpem::diagnosis
