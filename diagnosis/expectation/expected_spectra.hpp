#pragma once
// What the estimator of a recording would measure if the model were true.

#include <vector>

#include "diagnosis/expectation/expectation.hpp"
#include "diagnosis/expectation/observed_channels.hpp"
#include "recordings/estimates/cross_spectra.hpp"

namespace railpem::diagnosis {

/// The kernel on the fine grid of an expectation.
recordings::KernelWeights expectation_weights(const recordings::WindowKernel& kernel, int oversampling);

/// Expectation of the windowed estimate: ∫|W(f − f')|² S(f') df' with S = Σ_s y_s y_sᴴ over all broadband sources with
/// their delays, plus P·K(f − f_l) for every line l of power P, plus noise. The single-wheel transfers are solved on a
/// coarse grid and interpolated; delays and irregularity enter analytically on the fine grid. `noise_psd`: per observed
/// channel, (m/s²)²/Hz, flat. Sensors of the case are applied. `reuse` says what is taken from `known`; `filled`
/// receives what others may reuse.
ExpectedSpectra expected_spectra(const pem::CaseParameters& parameters, double speed_m_per_s,
                                 const recordings::WindowKernel& kernel, const std::vector<ObservedChannel>& channels,
                                 const std::vector<double>& noise_psd, const ExpectationOptions& options,
                                 const ExpectationCache* known = nullptr, Reuse reuse = Reuse::nothing,
                                 ExpectationCache* filled = nullptr);

/// tr(S⁻¹Ŝ)/channels at every bin: 1 on average when the model predicts what the estimator measures.
std::vector<double> whitened_trace(const ExpectedSpectra& expected, const recordings::CrossSpectra& measured,
                                   const std::vector<ObservedChannel>& channels);

}  // namespace railpem::diagnosis
