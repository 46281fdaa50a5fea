#pragma once
// The equal seats that stand for seats of which some have failed at random.

#include "lanes/factor_curve.hpp"
#include "track/track_modifiers.hpp"
#include "track/track_parameters.hpp"

namespace railpem::track {

/// Factor on stiffness and dashpot of every pad such that waves on the track go as they do in the mean over all draws
/// of failed seats: the coherent potential of single seats (Soven 1967, Phys. Rev. 156; Sheng 2006, Introduction to
/// Wave Scattering, chapter 3). A seat of stiffness s in the place of an equal one, K, acts on it by (s − K)/(1 + (s −
/// K)·q), q the deflection over a seat of the equal track by a unit force there, and K is such that this is nothing in
/// the mean over sound and failed ones. The mean of the stiffness, which it replaces, is the limit of a small q. What
/// several failed seats in a row do together is left out. `pad_stiffness_n_per_m`: K0 of the sound pads. Empty where
/// none fail.
lanes::FactorCurve mean_of_failed(const TrackParameters& track, double pad_stiffness_n_per_m,
                                  const TrackModifiers& modifiers = {});

}  // namespace railpem::track
