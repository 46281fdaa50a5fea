#include "recordings/estimates/averages.hpp"

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

/// |c(b, j)|² for every distance in bins and every overlap j of one window and hop.
std::vector<std::vector<double>> overlap_coherences(const Segmentation& segments) {
    // The closed form depends on n/N only: a window of a few hundred points gives the same sums as one of many
    // thousands.
    constexpr std::size_t enough = 512;
    const bool reduce = segments.length > enough && (segments.hop * enough) % segments.length == 0;
    const std::size_t length = reduce ? enough : segments.length,
                      hop = reduce ? segments.hop * enough / segments.length : segments.hop;
    const std::vector<double> window = window_samples(segments.window, length);
    const double energy = std::inner_product(window.begin(), window.end(), window.begin(), 0.0);
    std::vector<std::vector<double>> result;
    for (std::size_t bins = 0; bins <= covariance_reach; ++bins) {
        result.emplace_back();
        const double step = 2.0 * std::numbers::pi * static_cast<double>(bins) / static_cast<double>(length);
        for (std::size_t shift = 0; shift < length; shift += hop) {
            std::complex<double> sum = 0.0;
            for (std::size_t n = 0; n + shift < length; ++n)
                sum += window[n] * window[n + shift] * std::polar(1.0, step * static_cast<double>(n));
            result.back().push_back(std::norm(sum) / (energy * energy));
        }
    }
    return result;
}

/// The same, remembered for the window and hop last asked for: bands and parts of a record ask for it thousands of
/// times.
const std::vector<std::vector<double>>& remembered_coherences(const Segmentation& segments) {
    thread_local Segmentation known;
    thread_local std::vector<std::vector<double>> table;
    if (table.empty() || known.window != segments.window || known.length != segments.length ||
        known.hop != segments.hop) {
        table = overlap_coherences(segments);
        known = segments;
    }
    return table;
}

}  // namespace

double relative_bin_covariance(const Segmentation& segments, std::size_t bins) {
    assert(segments.count > 0 && segments.hop > 0);
    if (bins > covariance_reach) return 0.0;
    const std::vector<double>& coherence = remembered_coherences(segments)[bins];
    const auto count = static_cast<double>(segments.count);
    double sum = coherence[0];
    for (std::size_t j = 1; j < segments.count && j < coherence.size(); ++j)
        sum += 2.0 * (1.0 - static_cast<double>(j) / count) * coherence[j];
    return sum / count;
}

double independent_averages(const Segmentation& segments) {
    return 1.0 / relative_bin_covariance(segments, 0);
}

double averages_per_bin(const Segmentation& segments) {
    double sum = relative_bin_covariance(segments, 0);
    for (std::size_t b = 1; b <= covariance_reach && b < segments.length / 2; ++b)
        sum += 2.0 * relative_bin_covariance(segments, b);
    return 1.0 / sum;
}

double band_averages(const Segmentation& segments, const std::vector<double>& weights) {
    const std::size_t reach = std::min(covariance_reach, weights.size() - 1);
    std::vector<double> shared;
    for (std::size_t b = 0; b <= reach; ++b) shared.push_back(relative_bin_covariance(segments, b));
    double sum = 0.0;
    for (std::size_t i = 0; i < weights.size(); ++i)
        for (std::size_t b = 0; b <= reach && i + b < weights.size(); ++b)
            sum += (b == 0 ? 1.0 : 2.0) * weights[i] * weights[i + b] * shared[b];
    const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
    return total * total / sum;
}

}  // namespace railpem::recordings
