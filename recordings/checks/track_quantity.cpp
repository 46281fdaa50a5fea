#include "recordings/checks/track_quantity.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "recordings/checks/median.hpp"
#include "recordings/units.hpp"

namespace railpem::recordings::checks {
namespace {

struct QuantityCandidate {
    double factor;
    int derivatives;
    const char* says;
};

constexpr std::array<QuantityCandidate, 13> candidates = {
    {{1.0, 0, ""},
     {1e3, 0, "receptance in mm/N (or m/kN)"},
     {1e6, 0, "receptance in um/N (or mm/kN)"},
     {1e9, 0, "receptance in nm/N (or um/kN)"},
     {1e12, 0, "receptance in nm/kN"},
     {1e-3, 0, "receptance with its force in mN"},
     {1.0, 1, "mobility in (m/s)/N"},
     {1e3, 1, "mobility in (mm/s)/N"},
     {1e6, 1, "mobility in (um/s)/N"},
     {1.0, 2, "accelerance in (m/s^2)/N"},
     {1e3, 2, "accelerance in (mm/s^2)/N or (m/s^2)/kN"},
     {1.0 / standard_gravity_m_per_s2, 2, "accelerance in g/N"},
     {1e3 / standard_gravity_m_per_s2, 2, "accelerance in g/kN"}}};

/// Of the lowest octave, where a track below its resonance is a spring: its receptance is level there. Nothing when the
/// slope is none of a spring's.
std::optional<int> derivatives_by_slope(const std::vector<double>& frequency, const std::vector<double>& magnitude) {
    std::vector<double> slopes;
    for (std::size_t i = 1; i < frequency.size() && frequency[i] <= 2.0 * frequency.front(); ++i)
        if (frequency.front() > 0.0 && magnitude[i] > 0.0 && magnitude.front() > 0.0)
            slopes.push_back(std::log(magnitude[i] / magnitude.front()) / std::log(frequency[i] / frequency.front()));
    if (slopes.empty()) return std::nullopt;
    constexpr double kClose = 0.35;  // a resonance an octave above the octave adds a third
    const double slope = median(slopes), whole = std::round(slope);
    if (whole < 0.0 || whole > 2.0 || std::abs(slope - whole) > kClose) return std::nullopt;
    return static_cast<int>(whole);
}

}  // namespace

TrackQuantity track_quantity(const std::vector<double>& frequency, const std::vector<double>& magnitude,
                             const std::vector<double>& expected, double scatter_db) {
    std::vector<double> level, wave;
    for (std::size_t i = 0; i < frequency.size(); ++i)
        if (frequency[i] > 0.0 && magnitude[i] > 0.0 && expected[i] > 0.0) {
            level.push_back(20.0 * std::log10(magnitude[i] / expected[i]));
            wave.push_back(20.0 * std::log10(2.0 * std::numbers::pi * frequency[i]));
        }
    TrackQuantity result;
    if (level.empty()) return result;
    result.level_db = median(level);
    const auto distance = [&](const QuantityCandidate& candidate) {
        std::vector<double> distances;
        for (std::size_t i = 0; i < level.size(); ++i)
            distances.push_back(
                std::abs(level[i] - 20.0 * std::log10(candidate.factor) - candidate.derivatives * wave[i]));
        return median(distances);
    };
    const std::optional<int> derivatives = derivatives_by_slope(frequency, magnitude);
    // A receptance in m/N unless it is four deviations off and something else is within three.
    const double right = distance(candidates.front());
    double best = right;
    for (const QuantityCandidate& candidate : candidates)
        if (const double own = distance(candidate); (!derivatives || candidate.derivatives == *derivatives) &&
                                                    own < best && right > 4.0 * scatter_db && own < 3.0 * scatter_db) {
            best = own;
            result.factor = candidate.factor;
            result.derivatives = candidate.derivatives;
            result.says = candidate.says;
        }
    return result;
}

}  // namespace railpem::recordings::checks
