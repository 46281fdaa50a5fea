#include "recordings/estimates/meeting_order.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "recordings/estimates/fourier_transform.hpp"
#include "recordings/estimates/speed_grid.hpp"

namespace railpem::recordings {

namespace {

using Complex = std::complex<double>;

/// Place of a pair of channels, first < second, in MeetingCorrelations::correlation.
std::size_t pair_index(std::size_t first, std::size_t second) {
    return second * (second - 1) / 2 + first;
}

/// A stretch of the samples in zeros, its transform.
std::vector<Complex> transformed(const std::vector<double>& samples, long begin, std::size_t length,
                                 const FourierTransform& transform) {
    std::vector<double> stretch(transform.length(), 0.0);
    for (std::size_t i = 0; i < length; ++i) {
        const long at = begin + static_cast<long>(i);
        if (at >= 0 && at < static_cast<long>(samples.size())) stretch[i] = samples[static_cast<std::size_t>(at)];
    }
    std::vector<Complex> spectrum(transform.bins());
    transform.forward(stretch.data(), spectrum.data());
    return spectrum;
}

/// Whitened correlation of the front stretch with the longer one, at the coarse rate of `inverse`. The longer one
/// begins `reach` before the front one, so that delay −reach stands first.
void correlate(const std::vector<Complex>& front, const std::vector<Complex>& longer, double bin_hz,
               const MeetingOptions& options, const FourierTransform& inverse, std::size_t delays,
               std::vector<float>& correlation) {
    std::vector<Complex> cross(inverse.bins(), 0.0);
    double used = 0.0;
    for (std::size_t k = 0; k < std::min(cross.size(), front.size()); ++k) {
        const double f = static_cast<double>(k) * bin_hz, power = std::abs(front[k]) * std::abs(longer[k]);
        if (f < options.from_hz || f > options.to_hz || power <= 0.0) continue;
        cross[k] = std::conj(front[k]) * longer[k] / power;
        used += 1.0;
    }
    std::vector<double> value(inverse.length());
    inverse.inverse(cross.data(), value.data());
    const double scale = used > 0.0 ? static_cast<double>(inverse.length()) / (2.0 * used) : 0.0;  // 1: quite alike
    for (std::size_t i = 0; i < delays; ++i) correlation.push_back(static_cast<float>(scale * value[i]));
}

/// All pairs in one window, which begins at a sample.
void add_window(const std::vector<std::vector<double>>& samples, long begin, double rate, double reach_s,
                const MeetingOptions& options, const FourierTransform& transform, const FourierTransform& inverse,
                MeetingCorrelations& all) {
    const auto length = static_cast<std::size_t>(options.window_s * rate);
    const auto reach = std::lround(reach_s * rate);
    std::vector<std::vector<Complex>> front, longer;
    for (const std::vector<double>& own : samples) {
        front.push_back(transformed(own, begin, length, transform));
        longer.push_back(transformed(own, begin - reach, length + 2 * static_cast<std::size_t>(reach), transform));
    }
    const double bin_hz = rate / static_cast<double>(transform.length());
    for (std::size_t second = 1; second < samples.size(); ++second)
        for (std::size_t first = 0; first < second; ++first)
            correlate(front[first], longer[second], bin_hz, options, inverse, 2 * all.reach + 1,
                      all.correlation[pair_index(first, second)]);
}

}  // namespace

double MeetingCorrelations::at(std::size_t first, std::size_t second, std::size_t window, double delay_s) const {
    if (first > second) return at(second, first, window, -delay_s);
    const double place = delay_s * rate_hz + static_cast<double>(reach);
    if (place < 0.0 || place >= static_cast<double>(2 * reach)) return 0.0;
    const auto i = static_cast<std::size_t>(place);
    const double share = place - static_cast<double>(i);
    const float* values = correlation[pair_index(first, second)].data() + window * (2 * reach + 1);
    return (1.0 - share) * values[i] + share * values[i + 1];
}

MeetingCorrelations meeting_correlations(const std::vector<std::vector<double>>& samples, double rate, double longest_m,
                                         const MeetingOptions& options) {
    MeetingCorrelations all{.channels = samples.size()};
    const double reach_s = longest_m / options.range.least_m_per_s;
    const double duration = samples.empty() ? 0.0 : static_cast<double>(samples.front().size()) / rate;
    const FourierTransform transform(
        fast_length(static_cast<std::size_t>((options.window_s + 2.0 * reach_s) * rate) + 2));
    const double bin_hz = rate / static_cast<double>(transform.length());
    // Six values per cycle of the fastest wave: then a line between them is as good as a curve.
    const FourierTransform inverse(fast_length(static_cast<std::size_t>(6.0 * options.to_hz / bin_hz)));
    all.rate_hz = bin_hz * static_cast<double>(inverse.length());
    all.reach = static_cast<std::size_t>(reach_s * all.rate_hz);
    all.hop_s = std::max(options.hop_s, duration / static_cast<double>(options.most_windows));
    all.correlation.resize(samples.size() * (samples.size() - 1) / 2);
    for (double begin = 0.0; begin + options.window_s <= duration; begin += all.hop_s, ++all.windows)
        add_window(samples, std::lround(begin * rate), rate, static_cast<double>(all.reach) / all.rate_hz, options,
                   transform, inverse, all);
    return all;
}

MeetingScore meeting_score(const MeetingCorrelations& all, const std::vector<double>& places,
                           const MeetingOptions& options) {
    constexpr double kStep = 0.004;  // as in running_speed()
    const SpeedGrid grid = speed_grid(options.range.least_m_per_s, options.range.most_m_per_s, kStep);
    const double pairs = static_cast<double>(all.channels * (all.channels - 1)) / 2.0;
    std::vector<std::vector<double>> score(all.windows, std::vector<double>(grid.count, 0.0));
    for (std::size_t second = 1; second < all.channels; ++second)
        for (std::size_t first = 0; first < second; ++first)
            for (std::size_t i = 0; i < grid.count; ++i) {
                const double delay = (places[first] - places[second]) / grid.at(i);
                for (std::size_t w = 0; w < all.windows; ++w) score[w][i] += all.at(first, second, w, delay) / pairs;
            }
    MeetingScore result;
    if (all.windows == 0) return result;
    const double slow = 10.0;  // m/s; below, the same acceleration would be more steps of the grid
    const auto most = static_cast<std::size_t>(std::ceil(options.most_acceleration * all.hop_s / slow / kStep));
    const std::vector<std::size_t> path = best_path(score, most);
    for (std::size_t w = 0; w < all.windows; ++w) {
        result.correlation += score[w][path[w]] / static_cast<double>(all.windows);
        result.speed_m_per_s.push_back(grid.at(path[w]));
    }
    return result;
}

double correlation_at(const MeetingCorrelations& all, const std::vector<double>& places,
                      const std::vector<double>& speed) {
    double sum = 0.0, count = 0.0;
    for (std::size_t second = 1; second < all.channels; ++second)
        for (std::size_t first = 0; first < second; ++first)
            for (std::size_t w = 0; w < std::min(all.windows, speed.size()); ++w) {
                sum += all.at(first, second, w, (places[first] - places[second]) / speed[w]);
                count += 1.0;
            }
    return count > 0.0 ? sum / count : 0.0;
}

}  // namespace railpem::recordings
