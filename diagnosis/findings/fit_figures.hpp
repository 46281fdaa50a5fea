#pragma once
// How well trials fit the recordings, on one scale.

#include "diagnosis/findings/diagnosis.hpp"
#include "diagnosis/fit/fit.hpp"

namespace railpem::diagnosis {

/// Figures of trials beside a diagnosed one, which says in which bands a recording speaks and where the zero of unseen
/// log-likelihoods lies.
class FigureScale {
  public:
    FigureScale(const Fit& diagnosed, const LikelihoodContext& context);

    /// Third octaves and log-likelihood per second of a part (per value where there is no time series). Seen: relative
    /// to the saturated model. Unseen: a part with fewer averages than channels has none; relative to what the
    /// diagnosed trial itself expects.
    FitFigures of(const Trial& trial, const Predictions& predictions, Part part) const;
    FitFigures of(const Fit& fit, Part part) const { return of(fit.trial, fit.predictions, part); }

  private:
    double seconds(Part part) const;
    double log_likelihood_of(const Trial& trial, const Predictions& predictions, Part part) const;

    const Fit& diagnosed_;
    const LikelihoodContext& context_;
    double unseen_reference_ = 0.0;
};

}  // namespace railpem::diagnosis
