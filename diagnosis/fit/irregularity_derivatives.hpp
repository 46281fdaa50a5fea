#pragma once
// How predictions change with the irregularity: its power enters them linearly, so that all nodes of its spline share
// one solution.

#include <complex>
#include <cstddef>
#include <vector>

#include "diagnosis/likelihood/likelihood.hpp"

namespace railpem::diagnosis {

/// Whether irregularity_derivatives() speaks for an observation: its transfers are known and do not depend on the
/// irregularity (no friction, no contact law that does), pads do not distort it (that goes with its square), and all of
/// it has the spline as a factor (no corrugation, which is added to it).
bool has_irregularity_derivatives(const Trial& trial, const LikelihoodContext& context, std::size_t observation,
                                  const Predictions& predictions);

/// Derivatives of the prediction of one observation with `unknowns` of kind irregularity (nodes of the spline, or the
/// level), in their order, as ExpectedSpectra::values: ∂/∂x of ∫K(f − f′)·S(f′)·e^{x·w(f′)}·H(f′)H(f′)ᴴ df′ at x = 0, w
/// the node's hat over the wavelength, and the same for what supports pass on to other frequencies. As many solutions
/// as differences, seventeen or so, would take one after the other are one here, each node's kernel over its octave
/// alone.
std::vector<std::vector<std::complex<double>>> irregularity_derivatives(const Trial& trial,
                                                                        const std::vector<const Unknown*>& unknowns,
                                                                        const LikelihoodContext& context,
                                                                        std::size_t observation,
                                                                        const Predictions& predictions);

}  // namespace railpem::diagnosis
