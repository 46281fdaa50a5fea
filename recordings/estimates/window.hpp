#pragma once

#include <complex>
#include <cstddef>
#include <vector>

namespace railpem::recordings {

enum class Window { rectangular, hann, hamming, blackman_harris };

/// The window's N samples, periodic form w_n = Σ_m a_m (−1)^m cos(2πmn/N) (Harris 1978).
std::vector<double> window_samples(Window window, std::size_t length);

/// What a segment estimate with this window measures. With the transform X(f) = Σ w_n x_n e^{−2πifn/f_s} and the
/// estimate Ŝ(f) = 2|X(f)|²/(f_s Σw²), the expectation is
///   E Ŝ(f) = ∫_0^{f_s/2} [K(f − f') S(f') + K(f + f') conj S(f')] df',   K(ν) = |W(ν)|²/(f_s Σ w²),  ∫ K dν = 1 over
///   f_s,
/// exactly, for every stationary process (Percival & Walden 1993, eq. 206c; cross-spectra alike). Wheel delays, leakage
/// and slopes of the spectrum are all in it, so a model is to be compared after the same smoothing.
struct WindowKernel {
    Window window = Window::hann;
    std::size_t length = 0;  ///< samples of a segment, N
    double sampling_rate_hz = 0.0;

    double bin_hz() const { return sampling_rate_hz / static_cast<double>(length); }
    /// K at the distance ν = f − f', 1/Hz. Even, periodic in the sampling rate.
    double operator()(double distance_hz) const;
};

/// The window's autocorrelation r_n = Σ_i w_i w_{i+n} / Σ w², n = 0 … N − 1 (r_0 = 1): the kernel K is its transform.
std::vector<double> window_autocorrelation(Window window, std::size_t length);

/// K as weights on a grid `oversampling` times finer than the bins: weight j, from −reach to +reach bins, is K(jδ)·δ
/// with δ = bin/oversampling, and all weights add up to 1. With reach = 8 a Hann kernel leaves 1e-8 of its area
/// outside.
struct KernelWeights {
    int oversampling = 4;
    int reach_bins = 8;
    std::vector<double> weights;  ///< 2·reach·oversampling + 1
};
KernelWeights kernel_weights(const WindowKernel& kernel, int oversampling = 4, int reach_bins = 8);

/// The expectation at the bins first_bin … first_bin + count − 1 of a one-sided (cross-)spectrum given on the fine grid
/// i·bin/oversampling, i = 0 … size − 1 (value 0 at i = 0; nothing beyond the end). The image at negative frequencies
/// is included. The fine grid must resolve the spectrum: oversampling ≥ 2·(1 + delay/segment) for a delay in its phase.
std::vector<std::complex<double>> smoothed_by_kernel(const KernelWeights& kernel,
                                                     const std::vector<std::complex<double>>& fine,
                                                     std::size_t first_bin, std::size_t count);

/// The same without truncating the kernel, for spectra of great range: by the autocorrelation, E Ŝ = FT(r · FT⁻¹ S).
/// `fine` covers 0 … f_s/2 in steps of bin/oversampling: oversampling·N/2 + 1 values. Returns all bins 0 … N/2.
std::vector<std::complex<double>> expected_estimate(const WindowKernel& kernel, int oversampling,
                                                    const std::vector<std::complex<double>>& fine);

}  // namespace railpem::recordings
