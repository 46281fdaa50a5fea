#include "recordings/estimates/wheel_orders.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>
#include <numbers>
#include <numeric>

namespace railpem::recordings {
namespace {

constexpr double least_radius_m = 0.30, most_radius_m = 0.65, speed_share = 0.03;

/// What the frequency of a line may be off: its error, and what a slight change of speed does to it.
double tolerance(const SpectralLine& line) {
    return 0.02 + 3.0 * line.frequency_error_hz + 2e-4 * line.frequency_hz;
}

/// Lines of all channels, one of those that are the same in several.
std::vector<SpectralLine> distinct(const std::vector<std::vector<SpectralLine>>& of_channels) {
    std::vector<SpectralLine> all, kept;
    for (const auto& lines : of_channels) all.insert(all.end(), lines.begin(), lines.end());
    std::sort(all.begin(), all.end(),
              [](const SpectralLine& a, const SpectralLine& b) { return a.frequency_hz < b.frequency_hz; });
    for (const SpectralLine& line : all)
        if (kept.empty() || line.frequency_hz - kept.back().frequency_hz > 0.1) kept.push_back(line);
    return kept;
}

bool fits(const SpectralLine& line, double rotation) {
    return std::abs(line.frequency_hz - std::round(line.frequency_hz / rotation) * rotation) <= tolerance(line);
}

/// Rotation refined by least squares through the origin over the lines that fit it.
WheelOrders refined(const std::vector<SpectralLine>& lines, double rotation) {
    WheelOrders result;
    result.lines = lines.size();
    double nn = 0.0, nf = 0.0, residual = 0.0;
    std::vector<double> frequencies;
    for (const SpectralLine& line : lines)
        if (fits(line, rotation)) {
            const double n = std::round(line.frequency_hz / rotation);
            nn += n * n;
            nf += n * line.frequency_hz;
            result.orders.push_back(static_cast<int>(n));
            frequencies.push_back(line.frequency_hz);
        }
    result.rotation_hz = nn > 0.0 ? nf / nn : rotation;
    for (std::size_t i = 0; i < frequencies.size(); ++i)
        residual += std::pow(frequencies[i] - result.orders[i] * result.rotation_hz, 2);
    if (frequencies.size() > 1)
        result.rotation_error_hz = std::sqrt(residual / static_cast<double>(frequencies.size() - 1) / nn);
    return result;
}

/// Without the lines that sleepers make, within the share that the speed may be off.
std::vector<SpectralLine> without_sleepers(std::vector<SpectralLine> lines, double passing_hz) {
    std::erase_if(lines, [&](const SpectralLine& line) {
        const double order = std::round(line.frequency_hz / passing_hz);
        return order >= 1.0 && std::abs(line.frequency_hz / passing_hz - order) < speed_share * order;
    });
    return lines;
}

/// Orders that speak for a rotation: all multiples of what may be the passing of sleepers are one.
int independent_orders(const std::vector<int>& orders, double rotation, double speed) {
    constexpr double least_spacing_m = 0.45, most_spacing_m = 0.8;
    int fewest = static_cast<int>(orders.size());
    for (int g = 2; g * rotation <= speed / least_spacing_m; ++g) {
        // The passing itself is the strongest line of sleepers: without it there are none.
        if (g * rotation < speed / most_spacing_m || std::find(orders.begin(), orders.end(), g) == orders.end())
            continue;
        const auto multiples = std::count_if(orders.begin(), orders.end(), [&](int order) { return order % g == 0; });
        if (multiples > 1) fewest = std::min(fewest, static_cast<int>(orders.size()) - static_cast<int>(multiples) + 1);
    }
    return fewest;
}

/// Whether all orders are multiples of one above the first: then the rotation could as well be that many times as fast.
bool share_a_factor(const std::vector<int>& orders) {
    int common = 0;
    for (const int order : orders) common = std::gcd(common, order);
    return common > 1;
}

}  // namespace

std::optional<WheelOrders> wheel_orders_of(const std::vector<std::vector<SpectralLine>>& lines_of_channels,
                                           double speed_m_per_s, double sleeper_spacing_m) {
    std::vector<SpectralLine> lines = distinct(lines_of_channels);
    if (sleeper_spacing_m > 0.0 && speed_m_per_s > 0.0)
        lines = without_sleepers(std::move(lines), speed_m_per_s / sleeper_spacing_m);
    if (lines.size() < 3 || speed_m_per_s <= 0.0) return std::nullopt;
    const double low = (1.0 - speed_share) * speed_m_per_s / (2.0 * std::numbers::pi * most_radius_m),
                 high = (1.0 + speed_share) * speed_m_per_s / (2.0 * std::numbers::pi * least_radius_m);
    const double highest = lines.back().frequency_hz;
    double step = 1e300, widest = 0.0;
    for (const SpectralLine& line : lines) {
        step = std::min(step, 0.5 * tolerance(line) * low / highest);
        widest = std::max(widest, tolerance(line));
    }
    // Rotations are distinct when their multiples at the highest line differ by its tolerance.
    const double distinct_rotations = (high - low) * (highest / low) / widest;
    WheelOrders best;
    for (double rotation = low; rotation <= high; rotation += step) {
        std::vector<int> orders;
        double chance = 0.0;
        for (const SpectralLine& line : lines) {
            if (fits(line, rotation)) orders.push_back(static_cast<int>(std::round(line.frequency_hz / rotation)));
            chance += 2.0 * tolerance(line) / rotation / static_cast<double>(lines.size());
        }
        const int count = sleeper_spacing_m > 0.0 ? static_cast<int>(orders.size())
                                                  : independent_orders(orders, rotation, speed_m_per_s);
        if (count < 3 || chance >= 1.0 || share_a_factor(orders)) continue;
        const double p =
            distinct_rotations * boost::math::cdf(boost::math::complement(
                                     boost::math::binomial(static_cast<double>(lines.size()), chance), count - 1));
        if (p < best.false_alarm) {
            best = refined(lines, rotation);
            best.false_alarm = p;
        }
    }
    if (best.false_alarm > 1e-3) return std::nullopt;
    return best;
}

std::string name_by_rotation(double frequency_hz, const WheelOrders& orders) {
    const double order = std::round(frequency_hz / orders.rotation_hz);
    if (order < 1.0 || std::abs(frequency_hz - order * orders.rotation_hz) >
                           0.05 + 2e-4 * frequency_hz + 3.0 * order * orders.rotation_error_hz)
        return "";
    return fmt::format("wheel order {:.0f}", order);
}

}  // namespace railpem::recordings
