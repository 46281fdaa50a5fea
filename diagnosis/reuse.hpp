#pragma once
// What a similar trial shares with one whose predictions are known.

#include "diagnosis/trial.hpp"

namespace railpem::diagnosis {

/// What a trial that differs in one unknown, or by one effect, shares with the trial that the predictions are of.
Reuse shared_with(const Trial& trial, const Unknown& unknown);
Reuse shared_with(const Trial& trial, const EffectInstance& effect);

/// Whether an unknown moves the prediction of an observation. Noise, floor and discrepancy stand beside it.
bool moves(const Unknown& unknown, const Trial& trial, const Observation& observation, std::size_t index);

}  // namespace railpem::diagnosis
