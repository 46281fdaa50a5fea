#pragma once
// The rival of what only gives up a belief: the case that keeps it.

#include "diagnosis/hypotheses/fitted_set.hpp"

namespace railpem::diagnosis {

/// Tolerances within which whoever believes something retunes it: it ends further away by chance for one belief in
/// twenty. RetunedNumber::outside begins there.
inline constexpr double kKeptTolerances = 2.0;

/// Whether a set gives up what is believed of an unknown of the retuned case: a number that it releases, the
/// irregularity where it names another spectrum, the passing of supports where it names more of it.
bool gives_up(const FittedSet& set, const Unknown& unknown);

/// An unknown that stays within kKeptTolerances of its belief, or within `reach` of it where that is further, and
/// within its own bounds where they are nearer.
Unknown kept(Unknown unknown, double reach);

/// The retuned case that keeps what a fitted set gives up, near the `retuned` one. Retuning weighs what the set gives
/// up, too, and leaves it for what that costs: from a set that only gives up a belief (a number eight tolerances off,
/// a track 8 dB smoother) it then differs by nothing but the cost, and predicts as well what no fit has seen. Whether
/// the belief was wrong is told by the case that keeps it. Nor are other beliefs given up in its place (no channel
/// shows one factor on vehicle, track and contact: a primary spring 1.5 times as stiff is all the rest a fifth too soft
/// and light): numbers, irregularity and the passing of supports stay within two tolerances, or no further away than in
/// the set, so that what it lacks is what the set gives up. No members, no prior. None where physics forbids it.
std::optional<FittedSet> fit_belief_kept(const BelievedCase& believed, const Fit& retuned, const FittedSet& set,
                                         const LikelihoodContext& context, const FitOptions& options);

}  // namespace railpem::diagnosis
