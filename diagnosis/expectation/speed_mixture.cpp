#include "diagnosis/expectation/speed_mixture.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "diagnosis/expectation/expectation_settings.hpp"
#include "recordings/estimates/window.hpp"

namespace railpem::diagnosis {

namespace {

using Complex = std::complex<double>;

/// Deviations of the slowness and their weights, every speed_step_s of the record.
struct Spread {
    std::vector<double> deviation, weight;
};

/// Σ over the segments of w² at every time of the record: how much each time counts in the estimate.
Spread spread_over(const recordings::TrackPath& path, const recordings::Segmentation& segments, double rate,
                   double from_s, double reference) {
    const std::vector<double> window = recordings::window_samples(segments.window, segments.length);
    const double length_s = static_cast<double>(segments.length) / rate,
                 hop_s = static_cast<double>(segments.hop) / rate;
    const double end_s = length_s + hop_s * static_cast<double>(segments.count - 1);
    const double step_s = kExpectationSettings.speed_step_s;
    Spread spread;
    for (double t = 0.5 * step_s; t < end_s; t += step_s) {
        double weight = 0.0;
        const auto last = std::min(static_cast<long>(segments.count) - 1, static_cast<long>(t / hop_s));
        for (long k = std::max(0L, static_cast<long>((t - length_s) / hop_s)); k <= last; ++k) {
            const auto sample = static_cast<long>((t - hop_s * static_cast<double>(k)) * rate);
            if (sample >= 0 && sample < static_cast<long>(window.size()))
                weight += std::pow(window[static_cast<std::size_t>(sample)], 2);
        }
        spread.deviation.push_back(reference / path.speed_at(from_s + t) - 1.0);
        spread.weight.push_back(weight);
    }
    return spread;
}

/// Weights that add up to one, and deviations without what chance adds to their spread.
void normalise(Spread& spread, double error) {
    double sum = 0.0, mean = 0.0, variance = 0.0;
    for (const double w : spread.weight) sum += w;
    for (double& w : spread.weight) w /= sum;
    for (std::size_t i = 0; i < spread.weight.size(); ++i) mean += spread.weight[i] * spread.deviation[i];
    for (std::size_t i = 0; i < spread.weight.size(); ++i)
        variance += spread.weight[i] * std::pow(spread.deviation[i] - mean, 2);
    const double kept = variance > 0.0 ? std::sqrt(std::max(0.0, 1.0 - error * error / variance)) : 0.0;
    for (double& d : spread.deviation) d = mean + kept * (d - mean);
}

/// Middles of speed_nodes parts of equal weight.
std::vector<double> quantiles(const Spread& spread) {
    std::vector<std::size_t> order(spread.deviation.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return spread.deviation[a] < spread.deviation[b]; });
    const std::size_t count = kExpectationSettings.speed_nodes;
    std::vector<double> sum(count, 0.0), weight(count, 0.0);
    double before = 0.0;
    for (const std::size_t i : order) {
        const double middle = before + 0.5 * spread.weight[i];
        const auto node = std::min(count - 1, static_cast<std::size_t>(middle * static_cast<double>(count)));
        sum[node] += spread.weight[i] * spread.deviation[i];
        weight[node] += spread.weight[i];
        before += spread.weight[i];
    }
    std::vector<double> nodes;
    for (std::size_t n = 0; n < count; ++n)
        nodes.push_back(weight[n] > 0.0 ? sum[n] / weight[n]
                        : nodes.empty() ? spread.deviation[order.front()]
                                        : nodes.back());
    return nodes;
}

}  // namespace

SpeedMixture::SpeedMixture(const recordings::TrackPath& path, const recordings::Segmentation& segments, double rate,
                           double from_s, double reference, double error, double most_cycles) {
    Spread spread = spread_over(path, segments, rate, from_s, reference);
    normalise(spread, error);
    nodes_ = quantiles(spread);
    // Cubic interpolation between phases that differ by a tenth of a radian at most is right to 1e-7.
    const double farthest = std::max({std::abs(least()), std::abs(most()), 1e-6});
    step_ = std::min(most_cycles, 0.1 / (2.0 * std::numbers::pi * farthest));
    const auto count = static_cast<std::size_t>(std::ceil(most_cycles / step_)) + 4;
    for (std::size_t k = 0; k < count; ++k) {
        const double x = step_ * (static_cast<double>(k) - 1.0);
        std::array<Complex, 2> value{};
        for (std::size_t i = 0; i < spread.weight.size(); ++i) {
            const Complex own = spread.weight[i] * std::polar(1.0, -2.0 * std::numbers::pi * x * spread.deviation[i]);
            value[0] += own;
            value[1] += spread.deviation[i] * own;
        }
        table_.push_back(value);
    }
}

std::array<Complex, 2> SpeedMixture::at(double cycles) const {
    const double place = std::min(std::abs(cycles) / step_ + 1.0, static_cast<double>(table_.size()) - 2.001);
    const auto i = static_cast<std::size_t>(place);
    const double t = place - static_cast<double>(i);
    const double a = -t * (t - 1.0) * (t - 2.0) / 6.0, b = (t + 1.0) * (t - 1.0) * (t - 2.0) / 2.0,
                 c = -(t + 1.0) * t * (t - 2.0) / 2.0, d = (t + 1.0) * t * (t - 1.0) / 6.0;
    std::array<Complex, 2> value;
    for (std::size_t k = 0; k < 2; ++k) {
        value[k] = a * table_[i - 1][k] + b * table_[i][k] + c * table_[i + 1][k] + d * table_[i + 2][k];
        if (cycles < 0.0) value[k] = std::conj(value[k]);
    }
    return value;
}

WheelCoherence wheel_coherence(const SpeedMixture& mixture, const std::vector<double>& wheels, double speed,
                               double frequency, double slope) {
    // Σ w·(1 + δ)·S(f·(1 + δ)) is 1 + (1 + slope)·δ to first order, over its own mean.
    const double mean = 1.0 + (1.0 + slope) * mixture.at(0.0)[1].real();
    WheelCoherence factor{};
    for (std::size_t j = 0; j < 4; ++j)
        for (std::size_t l = 0; l <= j; ++l) {
            // Wheel l meets a wave before wheel j does: d_j − d_l = x_l − x_j.
            const auto [phi, first] = mixture.at(frequency * (wheels[l] - wheels[j]) / speed);
            Complex rest = (phi + (1.0 + slope) * first) / mean;
            for (std::size_t r = 0; r < l; ++r) rest -= factor[j][r] * std::conj(factor[l][r]);
            if (l == j)
                factor[j][j] = std::sqrt(std::max(0.0, rest.real()));
            else
                factor[j][l] = factor[l][l].real() > 1e-9 ? rest / factor[l][l].real() : Complex(0.0);
        }
    return factor;
}

}  // namespace railpem::diagnosis
