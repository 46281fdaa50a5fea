#pragma once
// What of a fit's misfit the unseen part of the recordings repeats.

#include "diagnosis/likelihood/likelihood.hpp"

namespace railpem::diagnosis {

/// Nats by which the truth, whatever it is, explains the recordings better than the fit, and the standard deviation of
/// that by chance.
struct RepeatedMisfit {
    double nats = 0.0;
    double deviation = 0.0;
    double seconds = 0.0;  ///< of record
};

/// With R = L⁻¹ŜL⁻ᴴ − 1 of a bin, S = LLᴴ the fit's prediction, ½n·tr(Δ²) are the nats that Δ = E[R] costs. R₁ of the
/// fitted and R₂ of the held-out part err independently, and no fit has seen R₂: E[tr(R₁R₂)] = tr(Δ²) whatever windows,
/// overlap and the distribution of Ŝ are, and 0 where the fit is right. The power that excited a bin is the recording's
/// own: R₁ and R₂ are taken perpendicular to it. The deviation is that of complex Wishart matrices, p/√(n₁n₂) per bin,
/// or what the bins show of it (median absolute deviation of sums over 2 Hz), whichever is more. Time series only; {0,
/// 0} without any.
RepeatedMisfit repeated_misfit(const Trial& trial, const Predictions& predictions, const LikelihoodContext& context);

}  // namespace railpem::diagnosis
