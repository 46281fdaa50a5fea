#pragma once

#include <complex>
#include <functional>
#include <vector>

#include "simulate/numerics/radau_step.hpp"
#include "track/pad_parameters.hpp"

namespace railpem::simulate {

/// Generalised Maxwell chain: a spring in parallel with relaxing branches, relative to the stiffness at the reference
/// frequency. Modulus: g(s) = equilibrium + Σ_b strength_b·sτ_b/(1 + sτ_b), every coefficient ≥ 0, so it is passive and
/// causal. Branch b keeps the internal force h_b, τ_b·dh_b/dt = E − h_b, and carries strength_b·(E − h_b), E the
/// elastic force.
struct RelaxationChain {
    double equilibrium = 1.0;
    std::vector<double> strength;
    std::vector<double> time_s;
    double largest_error = 0.0;  ///< relative, of the complex modulus against the law, over 1 to 400 Hz

    std::complex<double> modulus(std::complex<double> s) const;
    double glassy() const;  ///< equilibrium + Σ strength
};

/// Frequencies over which a chain is fitted, Hz; the error is stated over 1 to 400 Hz.
inline constexpr double chain_from_hz = 0.5;
inline constexpr double chain_to_hz = 800.0;

/// Chain that follows a complex modulus given on (chain_from_hz, chain_to_hz): relative least squares with fixed
/// relaxation times two and a half to the decade and non-negative strengths.
RelaxationChain fit_chain(const std::function<std::complex<double>(double frequency_hz)>& modulus);

/// The law of the pads relative to K0: (f/f0)^k·(1 + i·tan(πk/2)) times (f/f_l)^{(2/π)·atan η}·(1 + iη), together one
/// power law; or the measured table. Laws that are not causal (a real power law, a constant loss factor) are replaced
/// by the causal one with the same exponent or loss: nothing else can be marched in time.
std::function<std::complex<double>(double frequency_hz)> pad_modulus(const track::PadParameters& pads);

/// The dashpot beside the chain: none where the causal loss law replaces it.
double pad_dashpot_n_s_per_m(const track::PadParameters& pads);

/// The chain of the case's pads: a bare spring when no law is set.
RelaxationChain pad_chain(const track::PadParameters& pads);

}  // namespace railpem::simulate
