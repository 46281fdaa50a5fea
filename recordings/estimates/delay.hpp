#pragma once

#include <vector>

namespace railpem::recordings {

struct DelayOptions {
    double least_s = -2.0;  ///< range in which the delay is looked for
    double most_s = 2.0;
    double from_hz = 1.0;
    double to_hz = 1e300;   ///< at most 0.8 of half the sampling rate
    double window_s = 2.0;  ///< of the final estimate, after the channels were shifted on top of each other
};

/// By how much `later` follows `earlier`.
struct Delay {
    bool found = false;  ///< a peak stands out of the correlation
    double seconds = 0.0;
    double standard_error_s = 0.0;
    bool inverted = false;     ///< the channels are alike with opposite signs
    double correlation = 0.0;  ///< of the whitened channels at the delay, coherence-weighted, 0 … 1
    double false_alarm = 1.0;  ///< that unrelated channels show such a peak anywhere in the range
};

/// The delay between two records of the same excitation, by the phase slope of their cross-spectrum weighted by
/// coherence.
///
/// First the peak of the whitened cross-correlation (Knapp & Carter 1976) within the range. Then one channel is shifted
/// on top of the other, so that the delay does not cost coherence, and τ maximises Σ_f w Re(Ŝ e^{iωτ})/|Ŝ|, w = γ²/(1 −
/// γ²) (the maximum-likelihood weight). The standard error is the larger of the Cramér–Rao bound and that seen in the
/// phases' scatter about the line, summed in blocks as wide as one period 1/τ of the ripple that a coupling of the two
/// places causes.
Delay estimate_delay(const std::vector<double>& earlier, const std::vector<double>& later, double sampling_rate_hz,
                     const DelayOptions& options = {});

}  // namespace railpem::recordings
