#pragma once
// What a recording can show at all, by its kind.

#include "diagnosis/effects/effect.hpp"
#include "diagnosis/observations/observation.hpp"

namespace railpem::diagnosis {

/// Whether an element of the structure moves what was recorded. A track without a vehicle knows rail, pads and support
/// only.
bool reaches(const Observation& observation, Element element);

/// Whether an effect could show. Spectra without cross-spectra know no delays between channels; quoted points have no
/// resolution, so the height of a spectral line in them means nothing; a track without a vehicle has no load on its
/// pads.
bool could_show(const Observation& observation, const Effect& effect);

/// What a verdict from these recordings rests on because some of them are no time series, one sentence each: what they
/// lack, and what is taken in place of it.
std::vector<std::string> scalar_basis(const std::vector<Observation>& observations);

/// "time series", "spectra", "quoted points", "receptance", "decay rate".
std::string kind_in_words(const Observation& observation);

}  // namespace railpem::diagnosis
