#pragma once
// What a set of effects cannot explain by its own law, however right it is.

#include "diagnosis/hypotheses/fitted_set.hpp"

namespace railpem::diagnosis {

/// Whether the law of a member is an approximation (Effect::approximate).
bool is_approximate(const FittedSet& set);

/// Share of the nats that a set explains which its own law may leave: what other effects or free corrections promise
/// beside it and does not exceed this is no sign that something else is missing. 0.5 % for laws that the frequency
/// domain has exactly (distance between record and solution, README.md), 3 % where the law of a member is an
/// approximation (Effect::approximate): 1 kN of friction left 1.5 %, rail dampers with dashpots in place of rubber 1.9
/// to 3.2 % before their loss could grow with the frequency.
double share_left(const FittedSet& set);

/// That share in nats, `retuned_score` being the score of nothing added; at least `least`.
double nats_left(const FittedSet& set, double retuned_score, double least);

/// Nats of misfit that the unseen part may repeat (repeated_misfit.hpp) beside a set: every bin counts there, not one
/// direction, so that a law linearised about the level leaves up to a quarter of what it explains (1 kN of friction in
/// a primary suspension: 15 %).
double misfit_left(const FittedSet& set, double retuned_score, double least);

/// Nats of misfit that the unseen part repeats, beyond four deviations of chance and beyond the solution's own distance
/// from marched records: 4 a second of nine channels, by judgement on six trials of three such records each.
double missed_by(const Fit& fit, const LikelihoodContext& context);

/// Whether a fit misses so much, 100 nats a second that the unseen part repeats, that its derivatives say nothing of
/// the believed case: its numbers are bent to little avail.
bool misses_much(const Fit& fit, const LikelihoodContext& context);

/// A number that has to be wrong beside an effect of structure: the effect may stand on a lower hill of its own
/// parameters, as in three marched trials of three (ballast at 91 Hz with a rail a fifth too heavy, for ballast at 245
/// Hz).
bool is_doubtful(const FittedSet& set);

}  // namespace railpem::diagnosis
