#pragma once
// How far the numbers of a case ended from what was believed of them.

#include "diagnosis/hypotheses/fitted_set.hpp"
#include "parameters/field.hpp"

namespace railpem::diagnosis {

/// The power with which a number of the case goes with one factor on vehicle, track and contact together, which moves
/// no acceleration: 1 for masses, inertias, stiffness, damping and the rail's bending (its second moment of area), −2/3
/// for the contact constant, whose δ = G·P^{2/3} (Hertz 1882) goes with the load, too; 0 otherwise.
double power_of_scale(parameters::Nature nature);

/// By how many of its tolerances that number of the case ends away from its belief that does so most, the common scale
/// taken off that all the others ask for: what the recordings do not know may end anywhere. The scale is taken off
/// where vehicle, track and contact are all uncertain. Numbers that a set releases do not count: they have a range of
/// their own (number_beyond_range()). Evidence weighs a belief by nats, of which strong effects have a hundred
/// thousand: what explains only with wheelsets a half too heavy explains something else.
double furthest_number(const FittedSet& set);

}  // namespace railpem::diagnosis
