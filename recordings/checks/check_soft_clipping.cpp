#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "recordings/checks/checks.hpp"
#include "recordings/estimates/confidence.hpp"
#include "recordings/units.hpp"

namespace railpem::recordings::checks {
namespace {

/// Which excursions are looked at: all, or those to one side.
enum class Sides { both, upper, lower };

/// Largest |value| of every stretch between two changes of sign, in falling order.
std::vector<double> peaks_of(const std::vector<double>& x, Sides sides) {
    std::vector<double> peaks;
    double largest = 0.0;
    bool positive = true;
    const auto end_stretch = [&] {
        if (largest > 0.0 && (sides == Sides::both || positive == (sides == Sides::upper))) peaks.push_back(largest);
        largest = 0.0;
    };
    for (const double value : x) {
        if ((value > 0.0) != positive) end_stretch();
        positive = value > 0.0;
        largest = std::max(largest, std::abs(value));
    }
    std::sort(peaks.begin(), peaks.end(), std::greater<>());
    return peaks;
}

/// How much the highest `share` of the peaks stands out over the threshold that they exceed, against what a Gaussian
/// channel shows.
struct Excess {
    double relative = 1.0;     ///< mean excess over that of Gaussian peaks
    double threshold = 0.0;    ///< exceeded by the share
    double probability = 1.0;  ///< that peaks of a Gaussian channel are as much alike
};

Excess excess_over(const std::vector<double>& peaks, double share) {
    // Neighbouring peaks of a resonance are alike: some three of them say as much as one.
    constexpr double peaks_per_independent = 3.0;
    const auto count = static_cast<std::size_t>(share * static_cast<double>(peaks.size()));
    Excess result;
    if (count < 30) return result;  // ten of them, by the number above
    result.threshold = peaks[count];
    if (result.threshold <= 0.0) return result;
    double mean = 0.0;
    for (std::size_t i = 0; i < count; ++i) mean += (peaks[i] - result.threshold) / static_cast<double>(count);
    // Rice's peaks have the tail of Rayleigh: P(peak > u) = exp(−u²/2σ²), so ln(1/share) = u²/2σ² and the excess over u
    // is nearly exponential with mean σ²/u·(1 − σ²/u²). A channel whose level changes has a longer tail.
    const double square = 1.0 / (2.0 * std::log(1.0 / share));
    const double expected = result.threshold * square * (1.0 - square);
    result.relative = mean / expected;
    const double independent = static_cast<double>(count) / peaks_per_independent;
    result.probability = 1.0 - chi_squared_exceeded(2.0 * independent * result.relative, 2.0 * independent);
    return result;
}

bool is_line_spectrum(const Evidence& evidence, std::size_t channel) {
    // The peaks of a sinusoid are alike without any clipping.
    constexpr double most = 0.1;
    double lines = 0.0, all = 0.0;
    for (const SpectralLine& line : evidence.lines[channel]) lines += line.mean_square;
    for (const double x : evidence.detrended[channel]) all += x * x;
    return lines > most * all / static_cast<double>(std::max<std::size_t>(1, evidence.detrended[channel].size()));
}

/// The more unlikely of two shares of the peaks: many that are cut a little, or a few that are cut flat.
Excess least_excess(const std::vector<double>& peaks) {
    const Excess most = excess_over(peaks, 0.1), highest = excess_over(peaks, 0.02);
    return most.probability < highest.probability ? most : highest;
}

/// Told of this channel already, or explained by something that was.
bool is_explained(const Evidence& evidence, std::size_t channel, const std::vector<Fault>& faults) {
    return std::any_of(faults.begin(), faults.end(), [&](const Fault& fault) {
        return (fault.kind == FaultKind::clipping || fault.kind == FaultKind::coarse_resolution ||
                fault.kind == FaultKind::constant) &&
               fault.channels.front() == evidence.name(channel);
    });
}

Fault saturation(const Evidence& evidence, std::size_t channel, Sides sides, const Excess& excess, double highest) {
    const double sign = sides == Sides::lower ? -1.0 : 1.0;
    const std::string unit = value_unit(evidence.series().channels[channel].description);
    Fault found;
    found.kind = FaultKind::clipping;
    found.severity = Severity::warning;
    found.channels = {evidence.name(channel)};
    found.says = fmt::format(
        "{}: the highest peaks, from {:.4g} to {:.4g} {}, differ {:.2g} times as much as those of a random channel; "
        "what lies above is lost, and lines and noise are made at other frequencies",
        sides == Sides::both    ? "clipped before a filter"
        : sides == Sides::upper ? "clipped on the upper side, and noise or a filter came after it"
                                : "clipped on the lower side, and noise or a filter came after it",
        sign * excess.threshold, sign * highest, unit, excess.relative);
    found.value = excess.relative;
    found.unit = "1";
    found.false_alarm = excess.probability;
    return found;
}

}  // namespace

void check_soft_clipping(const Evidence& evidence, std::vector<Fault>& faults) {
    constexpr double clearly_alike = 0.5;  // a channel need not be quite Gaussian to be sound
    for (std::size_t i = 0; i < evidence.series().channels.size(); ++i) {
        if (is_explained(evidence, i, faults) || is_line_spectrum(evidence, i)) continue;
        for (const Sides sides : {Sides::both, Sides::upper, Sides::lower}) {
            const std::vector<double> peaks = peaks_of(evidence.detrended[i], sides);
            const Excess excess = least_excess(peaks);
            if (excess.probability > false_alarm || excess.relative > clearly_alike) continue;
            faults.push_back(saturation(evidence, i, sides, excess, peaks.front()));
            break;
        }
    }
}

}  // namespace railpem::recordings::checks
