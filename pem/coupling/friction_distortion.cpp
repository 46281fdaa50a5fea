#include "pem/coupling/friction_distortion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unsupported/Eigen/FFT>

namespace railpem::pem {

namespace {

/// Long enough for the third harmonic of the highest line, which is where most of what asin adds lies.
std::size_t transform_length(std::size_t highest) {
    std::size_t length = 16;
    while (length < 8 * (highest + 1)) length *= 2;
    return length;
}

/// A stage has few pairs of elements and many lines: one plan serves them all. Correlations are real, so that half of a
/// spectrum says everything.
Eigen::FFT<double> half_spectra() {
    Eigen::FFT<double> transform;
    transform.SetFlag(Eigen::FFT<double>::HalfSpectrum);
    return transform;
}

/// Correlation at the lags of the transform from one-sided spectra.
std::vector<double> correlation_of(const VelocitySpectra& velocity, std::size_t pair, std::size_t offset,
                                   std::size_t length, Eigen::FFT<double>& transform) {
    const double weight = 0.5 * velocity.step_hz * static_cast<double>(length);  // the transform divides by its length
    std::vector<std::complex<double>> half(length / 2 + 1, 0.0);
    for (std::size_t k = 0; k < velocity.lines; ++k)
        half[k + offset] = weight * velocity.values[k * velocity.elements * velocity.elements + pair];
    std::vector<double> lags;
    transform.inv(lags, half);
    return lags;
}

}  // namespace

std::vector<std::complex<double>> friction_distortion(const VelocitySpectra& velocity, double force_n) {
    const std::size_t n = velocity.elements,
                      offset = std::max<std::size_t>(
                          1, static_cast<std::size_t>(std::lround(velocity.from_hz / velocity.step_hz)));
    const std::size_t length = transform_length(velocity.lines + offset);
    Eigen::FFT<double> transform = half_spectra();
    std::vector<std::vector<double>> own_lags;
    for (std::size_t i = 0; i < n; ++i)
        own_lags.push_back(correlation_of(velocity, i * (n + 1), offset, length, transform));
    std::vector<std::complex<double>> result(velocity.lines * n * n, 0.0), half;
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i; j < n; ++j) {
            // Variances by the same transform as the lags: asin bends infinitely where ρ = 1, and a rounding of 1e-16
            // would be one of 1e-8.
            const double both = std::sqrt(own_lags[i].front() * own_lags[j].front());
            if (!(both > 0.0)) continue;
            std::vector<double> lags =
                i == j ? own_lags[i] : correlation_of(velocity, i * n + j, offset, length, transform);
            for (double& lag : lags) {
                const double rho = std::clamp(lag / both, -1.0, 1.0);
                lag = force_n * force_n * (2.0 / std::numbers::pi) * (std::asin(rho) - rho);
            }
            transform.fwd(half, lags);
            for (std::size_t k = 0; k < velocity.lines; ++k) {
                const std::complex<double> own =
                    2.0 * half[k + offset] / (static_cast<double>(length) * velocity.step_hz);
                result[(k * n + i) * n + j] = own;
                result[(k * n + j) * n + i] = std::conj(own);
            }
        }
    return result;
}

}  // namespace railpem::pem
