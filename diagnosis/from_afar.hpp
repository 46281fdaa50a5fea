#pragma once
// Fits of effects so strong that nothing near the retuned case leads to them.

#include <functional>

#include "diagnosis/fitted_set.hpp"

namespace railpem::diagnosis {

/// The candidate fitted from the believed numbers, from its typical values and from either end of every range, with a likelihood that is
/// blunt enough (a floor of 10 %) to have one broad maximum: the best of these. `between` is called between steps and may throw to stop.
FittedSet blunt_from_afar(const BelievedCase& believed, const Candidate& candidate, const LikelihoodContext& context, const std::function<void()>& between);

/// A set fitted with the blunt likelihood, sharpened in small steps.
FittedSet sharpened(const BelievedCase& believed, const FittedSet& blunt, const LikelihoodContext& context, const std::function<void()>& between);

}  // namespace railpem::diagnosis
