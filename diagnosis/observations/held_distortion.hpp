#pragma once
// What the contacts of a recorded run distort, as far as it is known before anything is fitted.

#include "diagnosis/observations/observation.hpp"

namespace railpem::diagnosis {

/// Puts pem::contact_distortion() beside the expectation of a time series. Its forces are those of the believed case,
/// with the power that the recorded wheels have beyond (or below) it, by third of an octave; without channels on wheels
/// as believed. No fit moves it: where numbers are far off, a source that grows with the fourth power of the forces is
/// a noise that explains anything. Effects that the case itself has are not in those forces.
void hold_contact_distortion(Observation& observation, const pem::CaseParameters& believed);

}  // namespace railpem::diagnosis
