#pragma once
// What the model of a trial says of the values of a scalar recording.

#include <complex>
#include <vector>

#include "diagnosis/observations/observation.hpp"

namespace railpem::diagnosis {

/// Logarithm of model over measured, one per value: real part of the levels, imaginary part (−π, π] of the phases where
/// they are known. Spectra: the solution itself, not smoothed by a window, without sleeper passing; lines only where
/// the resolution of the recording is known, spread by a Hann kernel of that width. Receptance: track without a
/// vehicle. Decay rate: EN 15461 from transfer functions averaged over the third-octave. `known`, `reuse`, `filled` as
/// in expected_spectra (spectra only).
std::vector<std::complex<double>> predict_scalars(const pem::CaseParameters& parameters, double speed_m_per_s,
                                                  const Observation& observation,
                                                  const ExpectationCache* known = nullptr, Reuse reuse = Reuse::nothing,
                                                  ExpectationCache* filled = nullptr);

}  // namespace railpem::diagnosis
