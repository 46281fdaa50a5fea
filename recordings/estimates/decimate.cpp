#include "recordings/estimates/decimate.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace railpem::recordings {
namespace {

constexpr double attenuation_db = 100.0;

/// Windowed sinc, odd in number, of sum one.
Eigen::VectorXd low_pass(double pass_hz, double stop_hz, double rate) {
    const double width = 2.0 * std::numbers::pi * (stop_hz - pass_hz) / rate;
    const auto half = static_cast<Eigen::Index>(std::ceil((attenuation_db - 8.0) / (2.285 * width) / 2.0));
    const double beta = 0.1102 * (attenuation_db - 8.7), cut = (pass_hz + stop_hz) / rate;
    Eigen::VectorXd weights(2 * half + 1);
    for (Eigen::Index n = -half; n <= half; ++n) {
        const double x = static_cast<double>(n), place = x / static_cast<double>(half);
        const double sinc = n == 0 ? cut : std::sin(std::numbers::pi * cut * x) / (std::numbers::pi * x);
        weights[n + half] = sinc * std::cyl_bessel_i(0.0, beta * std::sqrt(1.0 - place * place));
    }
    return weights / weights.sum();
}

}  // namespace

std::size_t decimation_factor(double sampling_rate_hz, double highest_hz) {
    return std::max<std::size_t>(1, static_cast<std::size_t>(sampling_rate_hz / (2.5 * highest_hz)));
}

std::vector<double> decimated(const std::vector<double>& samples, double sampling_rate_hz, std::size_t factor,
                              double highest_hz) {
    if (factor <= 1) return samples;
    const double kept_rate = sampling_rate_hz / static_cast<double>(factor);
    const Eigen::VectorXd weights = low_pass(highest_hz, kept_rate - highest_hz, sampling_rate_hz);
    const Eigen::Index half = weights.size() / 2, all = static_cast<Eigen::Index>(samples.size());
    const Eigen::Map<const Eigen::VectorXd> x(samples.data(), all);
    std::vector<double> result;
    result.reserve(samples.size() / factor + 1);
    for (Eigen::Index at = 0; at < all; at += static_cast<Eigen::Index>(factor)) {
        const Eigen::Index begin = std::max<Eigen::Index>(0, at - half), end = std::min(all, at + half + 1);
        const auto used = weights.segment(begin - (at - half), end - begin);
        const double sum = x.segment(begin, end - begin).dot(used);
        result.push_back(end - begin == weights.size() ? sum : sum / used.sum());
    }
    return result;
}

}  // namespace railpem::recordings
