#pragma once
// How predictions change with the imperfections of every record: what wheels meet alone, and calibrations. Both are
// known in closed form from the prediction itself.

#include <complex>
#include <cstddef>
#include <vector>

#include "diagnosis/likelihood/likelihood.hpp"

namespace railpem::diagnosis {

/// What each wheel meets by itself adds to the prediction of an observation, as ExpectedSpectra::values, gains of the
/// trial included; all zero where nothing is met alone. The caches of `predictions` are there.
std::vector<std::complex<double>> met_alone_spectra(const Trial& trial, const LikelihoodContext& context,
                                                    std::size_t observation, const Predictions& predictions);

/// Derivatives with `unknowns` of kind met_alone, in their order, as ExpectedSpectra::values: w·S, w the node's hat
/// over the wavelength and S the met_alone_spectra(), because the unknown is the logarithm of a share.
std::vector<std::vector<std::complex<double>>> met_alone_derivatives(const Trial& trial,
                                                                     const std::vector<const Unknown*>& unknowns,
                                                                     const LikelihoodContext& context,
                                                                     std::size_t observation,
                                                                     const Predictions& predictions);

/// Derivative with the logarithm of the power of one channel's calibration: half of every element in the channel's row
/// and column, the whole of its power.
std::vector<std::complex<double>> calibration_derivative(const ExpectedSpectra& prediction, std::size_t channel);

}  // namespace railpem::diagnosis
