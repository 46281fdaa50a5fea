#pragma once
// What a similar trial shares with one whose predictions are known.

#include "diagnosis/model/trial.hpp"

namespace railpem::diagnosis {

/// What a trial that differs in one unknown, or by one effect, shares with the trial that the predictions are of.
Reuse shared_with(const Trial& trial, const Unknown& unknown);
Reuse shared_with(const Trial& trial, const EffectInstance& effect);

/// What the probe of an effect shares, which is next to nothing (Candidate::probe). Of lines and bands of roughness it
/// is said here that laws linearised about the level stay as they are: what they do to the level is no stronger, but
/// all over the band, as the strength of those laws is, which the screening projects out.
Reuse shared_with_probe(const Trial& trial, const EffectInstance& probe);

/// Whether an unknown moves the prediction of an observation. Noise, floor and discrepancy stand beside it.
bool moves(const Unknown& unknown, const Trial& trial, const Observation& observation, std::size_t index);

}  // namespace railpem::diagnosis
