#include "track/pads/fit_power_law.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <numeric>

namespace railpem::track {

namespace {

constexpr double kQuarterTurn = 0.5 * std::numbers::pi;

double mean(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

}  // namespace

PowerLawFit fit_power_law(const std::vector<double>& frequency_hz, const std::vector<double>& storage,
                          const std::vector<double>& loss_factor, double reference_hz) {
    const std::size_t n = frequency_hz.size();
    assert(n >= 2 && storage.size() == n && loss_factor.size() == n);
    std::vector<double> x(n), y(n);
    for (std::size_t i = 0; i < n; ++i) {
        x[i] = std::log(frequency_hz[i] / reference_hz);
        y[i] = std::log(storage[i] * std::hypot(1.0, loss_factor[i]));
    }
    const double x_mean = mean(x), y_mean = mean(y);
    double above = 0.0, below = static_cast<double>(n) * kQuarterTurn * kQuarterTurn;
    for (std::size_t i = 0; i < n; ++i) {
        above += (x[i] - x_mean) * (y[i] - y_mean) + kQuarterTurn * std::atan(loss_factor[i]);
        below += (x[i] - x_mean) * (x[i] - x_mean);
    }
    PowerLawFit fit;
    fit.exponent = above / below;
    const double level = y_mean - fit.exponent * x_mean;  // ln|E| at the reference frequency
    fit.storage_at_reference = std::exp(level) * std::cos(kQuarterTurn * fit.exponent);
    for (std::size_t i = 0; i < n; ++i) {
        const double error_db = 20.0 / std::numbers::ln10 * (y[i] - level - fit.exponent * x[i]);
        const double loss_error = loss_factor[i] - std::tan(kQuarterTurn * fit.exponent);
        fit.rms_error_db += error_db * error_db / static_cast<double>(n);
        fit.largest_error_db = std::max(fit.largest_error_db, std::abs(error_db));
        fit.rms_loss_factor_error += loss_error * loss_error / static_cast<double>(n);
    }
    fit.rms_error_db = std::sqrt(fit.rms_error_db);
    fit.rms_loss_factor_error = std::sqrt(fit.rms_loss_factor_error);
    return fit;
}

}  // namespace railpem::track
