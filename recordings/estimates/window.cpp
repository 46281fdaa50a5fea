#include "recordings/estimates/window.hpp"

#include <array>
#include <cassert>
#include <cmath>
#include <numbers>
#include <numeric>

#include "recordings/estimates/fourier_transform.hpp"

namespace railpem::recordings {
namespace {

constexpr double pi = std::numbers::pi;

/// Coefficients a_m of the cosine sum (Harris 1978, table 1; unused ones are 0).
std::array<double, 4> coefficients(Window window) {
    switch (window) {
        case Window::rectangular:
            return {1.0, 0.0, 0.0, 0.0};
        case Window::hann:
            return {0.5, 0.5, 0.0, 0.0};
        case Window::hamming:
            return {0.54, 0.46, 0.0, 0.0};
        case Window::blackman_harris:
            return {0.35875, 0.48829, 0.14128, 0.01168};
    }
    assert(false);
    return {};
}

/// Σ_{n<N} e^{−2πi n x}, x in cycles per sample.
std::complex<double> dirichlet(double x, std::size_t length) {
    x -= std::round(x);
    const double n = static_cast<double>(length);
    if (std::abs(x) * n < 1e-9) return n;
    return std::polar(1.0, -pi * (n - 1.0) * x) * std::sin(pi * n * x) / std::sin(pi * x);
}

}  // namespace

std::vector<double> window_samples(Window window, std::size_t length) {
    const auto a = coefficients(window);
    std::vector<double> samples(length);
    for (std::size_t n = 0; n < length; ++n)
        for (std::size_t m = 0; m < a.size(); ++m)
            samples[n] += (m % 2 == 0 ? 1.0 : -1.0) * a[m] *
                          std::cos(2.0 * pi * static_cast<double>(m * n) / static_cast<double>(length));
    return samples;
}

double WindowKernel::operator()(double distance_hz) const {
    const auto a = coefficients(window);
    const double n = static_cast<double>(length);
    std::complex<double> sum = a[0] * dirichlet(distance_hz / sampling_rate_hz, length);
    double energy = a[0] * a[0] * n;
    for (std::size_t m = 1; m < a.size(); ++m) {
        if (a[m] == 0.0) continue;
        const double shift = static_cast<double>(m) / n;
        sum += (m % 2 == 0 ? 0.5 : -0.5) * a[m] *
               (dirichlet(distance_hz / sampling_rate_hz - shift, length) +
                dirichlet(distance_hz / sampling_rate_hz + shift, length));
        energy += 0.5 * a[m] * a[m] * n;
    }
    return std::norm(sum) / (sampling_rate_hz * energy);
}

std::vector<double> window_autocorrelation(Window window, std::size_t length) {
    std::vector<double> padded = window_samples(window, length);
    const double energy = std::inner_product(padded.begin(), padded.end(), padded.begin(), 0.0);
    const FourierTransform transform(fast_length(2 * length));
    padded.resize(transform.length(), 0.0);
    std::vector<std::complex<double>> spectrum(transform.bins());
    transform.forward(padded.data(), spectrum.data());
    for (std::complex<double>& value : spectrum) value = std::norm(value) / energy;
    transform.inverse(spectrum.data(), padded.data());
    padded.resize(length);
    return padded;
}

KernelWeights kernel_weights(const WindowKernel& kernel, int oversampling, int reach_bins) {
    assert(oversampling >= 1 && reach_bins >= 1);
    KernelWeights result{oversampling, reach_bins, {}};
    const int reach = oversampling * reach_bins;
    for (int j = -reach; j <= reach; ++j) result.weights.push_back(kernel(j * kernel.bin_hz() / oversampling));
    const double sum = std::accumulate(result.weights.begin(), result.weights.end(), 0.0);
    for (double& weight : result.weights) weight /= sum;
    return result;
}

std::vector<std::complex<double>> smoothed_by_kernel(const KernelWeights& kernel,
                                                     const std::vector<std::complex<double>>& fine,
                                                     std::size_t first_bin, std::size_t count) {
    const auto reach = static_cast<std::ptrdiff_t>(kernel.oversampling * kernel.reach_bins);
    const auto size = static_cast<std::ptrdiff_t>(fine.size());
    std::vector<std::complex<double>> result(count);
    for (std::size_t bin = 0; bin < count; ++bin) {
        const auto centre =
            static_cast<std::ptrdiff_t>((first_bin + bin) * static_cast<std::size_t>(kernel.oversampling));
        std::complex<double> sum = 0.0;
        for (std::ptrdiff_t j = -reach; j <= reach; ++j) {
            const std::ptrdiff_t at = centre + j;
            if (at >= size || -at >= size) continue;
            // A one-sided spectrum goes on to negative frequencies as its conjugate.
            sum += kernel.weights[static_cast<std::size_t>(j + reach)] *
                   (at >= 0 ? fine[static_cast<std::size_t>(at)] : std::conj(fine[static_cast<std::size_t>(-at)]));
        }
        result[bin] = sum;
    }
    return result;
}

std::vector<std::complex<double>> expected_estimate(const WindowKernel& kernel, int oversampling,
                                                    const std::vector<std::complex<double>>& fine) {
    const std::size_t length = kernel.length * static_cast<std::size_t>(oversampling);
    assert(kernel.length % 2 == 0 && fine.size() == length / 2 + 1);
    const std::vector<double> lag_window = window_autocorrelation(kernel.window, kernel.length);
    std::vector<double> correlation(length);
    const FourierTransform wide(length);
    wide.inverse(fine.data(), correlation.data());
    // Lags −N … N − 1 weighted and wrapped onto the N points of a segment: its bins are every oversampling-th of the
    // wide ones.
    std::vector<double> wrapped(kernel.length, 0.0);
    for (std::size_t n = 0; n < kernel.length; ++n) wrapped[n] += lag_window[n] * correlation[n];
    for (std::size_t n = 1; n < kernel.length; ++n)
        wrapped[kernel.length - n] += lag_window[n] * correlation[length - n];
    const FourierTransform narrow(kernel.length);
    std::vector<std::complex<double>> expected(narrow.bins());
    narrow.forward(wrapped.data(), expected.data());
    return expected;
}

}  // namespace railpem::recordings
