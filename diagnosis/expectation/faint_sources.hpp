#pragma once
// Sources of excitation so faint that the window's kernel does not count.

#include <vector>

#include "diagnosis/expectation/source_spectra.hpp"

namespace railpem::diagnosis {

/// Adds sources as they are at every bin: what a window's leakage and delays change of them is some per cent of tens of
/// dB below. Of what wheels meet one after the other, not DelayedSpectrum::under_wheels. All together: T·(Σ
/// power·share·shareᵀ)·Tᴴ, so that the number of sources hardly counts.
void add_as_they_are(const pem::WheelTransfers& transfers, const std::vector<pem::DelayedSpectrum>& sources,
                     const std::vector<double>& wheels_m, double speed_m_per_s, double bin_hz,
                     ExpectedSpectra& expected);

/// Adds what each wheel meets by itself (Modifiers::share_met_alone()) of a source: a local matter at every frequency,
/// without delays.
void add_met_alone(const pem::CaseParameters& parameters, const pem::WheelTransfers& transfers,
                   const pem::DelayedSpectrum& source, const std::vector<double>& wheels_m, double speed_m_per_s,
                   double bin_hz, ExpectedSpectra& expected);

}  // namespace railpem::diagnosis
