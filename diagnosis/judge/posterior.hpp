#pragma once
// From the evidence of sets to probabilities of sets and of places.

#include <functional>

#include "diagnosis/judge/verdict.hpp"

namespace railpem::diagnosis {

/// Probabilities of all sets, of nothing and of the unknown; sums to 1. Friction that may be of another law shares the
/// probability of the best set with it.
std::vector<EffectSet> posterior_of(const NamingResult& naming, const Decision& decision);

/// That of all sets together which have something.
double probability_with(const NamingResult& naming, const Decision& decision,
                        const std::function<bool(const FittedSet&)>& has);

/// Places with their probability: those of the sets weighted by their probability, the unknown's by its evidence. Where
/// the verdict is `unexplained` the best set shares its own with the place where a free correction beside it would
/// bring most, by the nats of both.
std::vector<PlaceEvidence> place_probabilities(const NamingResult& naming, const PlaceStudy& places,
                                               const Decision& decision, const VerdictThresholds& thresholds = {});

}  // namespace railpem::diagnosis
