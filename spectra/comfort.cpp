#include "spectra/comfort.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "spectra/frequency_weighting.hpp"
#include "spectra/integrate_psd.hpp"

namespace railpem::spectra {

namespace {

constexpr double needed_low_hz = 0.5;
constexpr double needed_high_hz = 80.0;

bool covers(std::span<const double> frequency_hz, double low_hz, double high_hz) {
    return !frequency_hz.empty() && frequency_hz.front() <= low_hz && frequency_hz.back() >= high_hz;
}

std::vector<double> weighted(std::span<const double> frequency_hz, std::span<const double> psd,
                             double (*weight)(double)) {
    std::vector<double> result(psd.size());
    for (std::size_t i = 0; i < psd.size(); ++i) result[i] = psd[i] * std::pow(weight(frequency_hz[i]), 2);
    return result;
}

// Power in bins of the same width, up to the last that has any.
std::vector<double> bin_powers(std::span<const double> frequency_hz, std::span<const double> psd, double width_hz) {
    std::vector<double> powers;
    for (double low = frequency_hz.front(); low < frequency_hz.back();
         low = frequency_hz.front() + width_hz * static_cast<double>(powers.size()))
        powers.push_back(*mean_square_between(frequency_hz, psd, low, std::min(low + width_hz, frequency_hz.back())));
    return powers;
}

// ∬ S(f) S(f') sinc²((f − f')T) df df'. Bins of 1/(2T) hold what the kernel can tell apart; at their distances k/(2T)
// it is 1 at 0, 4/(πk)² for odd k and 0 for even k.
double variance_of_mean_square(const std::vector<double>& powers) {
    double sum = 0.0;
    for (std::size_t i = 0; i < powers.size(); ++i) {
        sum += powers[i] * powers[i];
        for (std::size_t k = 1; i + k < powers.size(); k += 2)
            sum += 2.0 * powers[i] * powers[i + k] * std::pow(2.0 / (std::numbers::pi * static_cast<double>(k)), 2);
    }
    return sum;
}

// 95th percentile of χ²_ν/ν (Wilson & Hilferty 1931).
double chi_square_95_over_degrees(double degrees) {
    constexpr double normal_95 = 1.6448536269514722;
    const double spread = 2.0 / (9.0 * degrees);
    return std::pow(1.0 - spread + normal_95 * std::sqrt(spread), 3);
}

}  // namespace

std::optional<double> weighted_rms_iso2631(std::span<const double> frequency_hz,
                                           std::span<const double> acceleration_psd) {
    if (!covers(frequency_hz, needed_low_hz, needed_high_hz)) return std::nullopt;
    return root_mean_square(frequency_hz, weighted(frequency_hz, acceleration_psd, weighting_wk));
}

std::optional<VerticalComfort> vertical_comfort_en12299(std::span<const double> frequency_hz,
                                                        std::span<const double> acceleration_psd) {
    if (!covers(frequency_hz, needed_low_hz, needed_high_hz)) return std::nullopt;
    constexpr double averaging_s = 5.0;
    const std::vector<double> psd = weighted(frequency_hz, acceleration_psd, weighting_wb);
    VerticalComfort comfort;
    const double power = mean_square(frequency_hz, psd);
    if (power == 0.0) return comfort;
    const double variance = variance_of_mean_square(bin_powers(frequency_hz, psd, 0.5 / averaging_s));
    comfort.degrees_of_freedom = 2.0 * power * power / variance;
    comfort.weighted_rms_m_per_s2 = std::sqrt(power);
    comfort.percentile_95_m_per_s2 = std::sqrt(power * chi_square_95_over_degrees(comfort.degrees_of_freedom));
    comfort.mean_comfort = 6.0 * comfort.percentile_95_m_per_s2;
    return comfort;
}

std::optional<double> sperling_index_vertical(std::span<const double> frequency_hz,
                                              std::span<const double> acceleration_psd) {
    const auto power = mean_square_between(
        frequency_hz, weighted(frequency_hz, acceleration_psd, weighting_sperling_vertical), 0.5, 30.0);
    if (!power) return std::nullopt;
    return std::pow(100.0 * std::numbers::sqrt2 * std::sqrt(*power), 0.3);
}

}  // namespace railpem::spectra
