#pragma once
// Fits of effects so strong that nothing near the retuned case leads to them.

#include <functional>

#include "diagnosis/fitted_set.hpp"

namespace railpem::diagnosis {

/// What may be there without a derivative at nothing that leads to it: effects of places that are `evident`, and those that follow the load, by effect, place and choice in the order of `candidates`;
/// without what is in `members` as often as it may be, sensors, irregularity and contact, and what comes in numbered variants, whose lines every derivative sees.
std::vector<std::vector<Candidate>> variants_from_afar(const std::vector<Candidate>& candidates, const std::vector<Candidate>& members,
                                                       const std::function<bool(Element)>& evident);

/// An effect fitted beside `members` (which start where their instances stand) from the believed numbers, from its typical values, from either end of every range and from the frequencies of `variants`
/// (not empty), with a likelihood that is blunt enough (a floor of 10 %) to have one broad maximum: the best of these. `between` is called between steps and may throw to stop.
FittedSet blunt_from_afar(const BelievedCase& believed, const std::vector<Candidate>& members, const std::vector<Candidate>& variants,
                          const LikelihoodContext& context, const std::function<void()>& between);

/// The floor at which it shows whether a set that was fitted with the blunt likelihood is worth sharpening.
constexpr double kHalfSharpFloor = 0.04;

/// A set fitted with the blunt likelihood, sharpened to kHalfSharpFloor.
FittedSet half_sharpened(const BelievedCase& believed, const FittedSet& blunt, const LikelihoodContext& context, const std::function<void()>& between);

/// The same sharpened to the end, in small steps.
FittedSet sharpened(const BelievedCase& believed, const FittedSet& half_sharp, const LikelihoodContext& context, const std::function<void()>& between);

}  // namespace railpem::diagnosis
