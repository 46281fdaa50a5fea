#include "pem/friction_distortion.hpp"

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

/// Correlation at the lags of the transform from one-sided spectra.
std::vector<double> correlation_of(const VelocitySpectra& velocity, std::size_t pair, std::size_t offset, std::size_t length) {
    std::vector<std::complex<double>> spectrum(length, 0.0), lags;
    for (std::size_t k = 0; k < velocity.lines; ++k) {
        const std::complex<double> own = 0.5 * velocity.step_hz * velocity.values[k * velocity.elements * velocity.elements + pair];
        spectrum[k + offset] += own;
        spectrum[length - k - offset] += std::conj(own);
    }
    Eigen::FFT<double> transform;
    transform.inv(lags, spectrum);
    std::vector<double> result(length);
    for (std::size_t m = 0; m < length; ++m) result[m] = static_cast<double>(length) * lags[m].real();
    return result;
}

}  // namespace

std::vector<std::complex<double>> friction_distortion(const VelocitySpectra& velocity, double force_n) {
    const std::size_t n = velocity.elements, offset = std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(velocity.from_hz / velocity.step_hz)));
    const std::size_t length = transform_length(velocity.lines + offset);
    std::vector<std::vector<double>> correlation;
    for (std::size_t pair = 0; pair < n * n; ++pair) correlation.push_back(correlation_of(velocity, pair, offset, length));
    std::vector<std::complex<double>> result(velocity.lines * n * n, 0.0);
    Eigen::FFT<double> transform;
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j) {
            const double both = std::sqrt(correlation[i * (n + 1)][0] * correlation[j * (n + 1)][0]);
            if (!(both > 0.0)) continue;
            std::vector<std::complex<double>> lags(length), spectrum;
            for (std::size_t m = 0; m < length; ++m) {
                const double rho = std::clamp(correlation[i * n + j][m] / both, -1.0, 1.0);
                lags[m] = force_n * force_n * (2.0 / std::numbers::pi) * (std::asin(rho) - rho);
            }
            transform.fwd(spectrum, lags);
            for (std::size_t k = 0; k < velocity.lines; ++k)
                result[(k * n + i) * n + j] = 2.0 * spectrum[k + offset] / (static_cast<double>(length) * velocity.step_hz);
        }
    return result;
}

}  // namespace railpem::pem
