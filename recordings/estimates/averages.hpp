#pragma once

#include <cstddef>
#include <vector>

#include "recordings/estimates/window.hpp"

namespace railpem::recordings {

/// Segments of N samples, each `hop` after the one before, `count` of them.
struct Segmentation {
    Window window = Window::hann;
    std::size_t length = 0;
    std::size_t hop = 0;
    std::size_t count = 0;
};

/// Relative covariance of two values of a segment-averaged spectrum `bins` apart, for a spectrum that is flat over the
/// window:
///   cov(Ŝ_k, Ŝ_{k+b})/S² = (1/K) Σ_{|j|<K} (1 − |j|/K) |c(b, j)|²,   c(b, j) = Σ_n w_n w_{n+jD} e^{2πibn/N} / Σ w²
/// (Welch 1967; Percival & Walden 1993, section 6.17; complex Gaussian values, so away from 0 and half the sampling
/// rate).
double relative_bin_covariance(const Segmentation& segments, std::size_t bins);

/// Independent averages in one bin: K / (1 + 2 Σ_j (1 − j/K) |c(0, j)|²). 2·averages degrees of freedom.
double independent_averages(const Segmentation& segments);

/// Independent averages per bin when all bins are used together: 1/Σ_b cov(b). A log-likelihood summed over the bins is
/// to be weighted with averages_per_bin/independent_averages, or it counts the same information more than once.
double averages_per_bin(const Segmentation& segments);

/// Independent averages of a mean over `weights.size()` neighbouring bins, each weighted with its share of the power:
/// (Σ w)²/Σ_b Σ_b' w_b w_b' cov(|b − b'|).
double band_averages(const Segmentation& segments, const std::vector<double>& weights);

}  // namespace railpem::recordings
