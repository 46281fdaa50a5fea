#include "recordings/averages.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>

namespace railpem::recordings {
namespace {

/// Bins beyond this distance share nothing that counts: with a Hann window |c|² < 1e-5 from three bins on.
constexpr std::size_t covariance_reach = 16;

/// |c(b, j)|² for the overlap j.
double overlap_coherence(const std::vector<double>& window, std::size_t hop, std::size_t bins, std::size_t j) {
    std::complex<double> sum = 0.0;
    double energy = 0.0;
    const double step = 2.0 * std::numbers::pi * static_cast<double>(bins) / static_cast<double>(window.size());
    for (std::size_t n = 0; n < window.size(); ++n) {
        energy += window[n] * window[n];
        if (n + j * hop < window.size()) sum += window[n] * window[n + j * hop] * std::polar(1.0, step * static_cast<double>(n));
    }
    return std::norm(sum) / (energy * energy);
}

double covariance(const std::vector<double>& window, const Segmentation& segments, std::size_t bins) {
    const auto count = static_cast<double>(segments.count);
    double sum = overlap_coherence(window, segments.hop, bins, 0);
    for (std::size_t j = 1; j < segments.count && j * segments.hop < segments.length; ++j)
        sum += 2.0 * (1.0 - static_cast<double>(j) / count) * overlap_coherence(window, segments.hop, bins, j);
    return sum / count;
}

}  // namespace

double relative_bin_covariance(const Segmentation& segments, std::size_t bins) {
    assert(segments.count > 0 && segments.hop > 0);
    // The closed form depends on n/N only: a window of a few hundred points gives the same sums as one of many thousands.
    constexpr std::size_t enough = 512;
    if (segments.length > enough && (segments.hop * enough) % segments.length == 0) {
        const Segmentation reduced{segments.window, enough, segments.hop * enough / segments.length, segments.count};
        return covariance(window_samples(reduced.window, enough), reduced, bins);
    }
    return covariance(window_samples(segments.window, segments.length), segments, bins);
}

double independent_averages(const Segmentation& segments) { return 1.0 / relative_bin_covariance(segments, 0); }

double averages_per_bin(const Segmentation& segments) {
    double sum = relative_bin_covariance(segments, 0);
    for (std::size_t b = 1; b <= covariance_reach && b < segments.length / 2; ++b) sum += 2.0 * relative_bin_covariance(segments, b);
    return 1.0 / sum;
}

double band_averages(const Segmentation& segments, const std::vector<double>& weights) {
    const std::size_t reach = std::min(covariance_reach, weights.size() - 1);
    std::vector<double> shared;
    for (std::size_t b = 0; b <= reach; ++b) shared.push_back(relative_bin_covariance(segments, b));
    double sum = 0.0;
    for (std::size_t i = 0; i < weights.size(); ++i)
        for (std::size_t b = 0; b <= reach && i + b < weights.size(); ++b) sum += (b == 0 ? 1.0 : 2.0) * weights[i] * weights[i + b] * shared[b];
    const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
    return total * total / sum;
}

}  // namespace railpem::recordings
