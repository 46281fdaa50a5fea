#pragma once
// What the contacts distort, once it is known better than it was believed.

#include <vector>

#include "diagnosis/hypotheses/naming_result.hpp"

namespace railpem::diagnosis {

/// The best set, or the retuned case where there is none.
const FittedSet& best_of(const NamingResult& naming);

/// Whether that has a member in the contact, or a contact that is a third softer or stiffer than believed (its
/// constant 1.85 times as large was `unexplained` at the pads, by what each wheel meets by itself). What contacts
/// distort goes with the fourth power of the forces, which were held as believed (held_distortion): wheelsets that are
/// heavier than believed, a gain or a flat loss factor looked like a contact that bends more than Hertz.
bool rests_on_held_forces(const NamingResult& naming, const BelievedCase& believed);

/// The observations with the contacts under the forces of a fitted set, its members in the contact left out. Time
/// series only; the others as they are.
std::vector<Observation> held_again(const FittedSet& set, const BelievedCase& believed,
                                    const std::vector<Observation>& observations);

/// Fits anew, near where they were, the retuned case, the sets that came near the best, and the best without its
/// members in the contact. What was fitted on other observations is let go.
void fit_again(NamingResult& naming, const BelievedCase& believed, const LikelihoodContext& context);

}  // namespace railpem::diagnosis
