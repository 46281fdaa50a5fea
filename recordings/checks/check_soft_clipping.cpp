#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "recordings/checks/checks.hpp"
#include "recordings/estimates/confidence.hpp"
#include "recordings/units.hpp"

namespace railpem::recordings::checks {
namespace {

/// Largest |value| of every stretch between two changes of sign, in falling order.
std::vector<double> peaks_of(const std::vector<double>& x) {
    std::vector<double> peaks;
    double largest = 0.0;
    for (std::size_t n = 0; n < x.size(); ++n) {
        if (n > 0 && (x[n] > 0.0) != (x[n - 1] > 0.0)) {
            peaks.push_back(largest);
            largest = 0.0;
        }
        largest = std::max(largest, std::abs(x[n]));
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
    if (count < 60) return result;
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

}  // namespace

void check_soft_clipping(const Evidence& evidence, std::vector<Fault>& faults) {
    constexpr double clearly_alike = 0.5;  // a channel need not be quite Gaussian to be sound
    for (std::size_t i = 0; i < evidence.series().channels.size(); ++i) {
        const auto told = [&](const Fault& fault) {
            return fault.kind == FaultKind::clipping && fault.channels.front() == evidence.name(i);
        };
        if (std::any_of(faults.begin(), faults.end(), told) || is_line_spectrum(evidence, i)) continue;
        const std::vector<double> peaks = peaks_of(evidence.detrended[i]);
        const Excess most = excess_over(peaks, 0.1), highest = excess_over(peaks, 0.02);
        const Excess& worse = most.probability < highest.probability ? most : highest;
        if (worse.probability > false_alarm || worse.relative > clearly_alike) continue;
        Fault found;
        found.kind = FaultKind::clipping;
        found.severity = Severity::warning;
        found.channels = {evidence.name(i)};
        found.says = fmt::format(
            "clipped before a filter: the highest peaks, from {:.4g} to {:.4g} {}, differ {:.2g} times as much as "
            "those "
            "of a random channel; what lies above is lost, and lines and noise are made at other frequencies",
            worse.threshold, peaks.front(), value_unit(evidence.series().channels[i].description), worse.relative);
        found.value = worse.relative;
        found.unit = "1";
        found.false_alarm = worse.probability;
        faults.push_back(std::move(found));
    }
}

}  // namespace railpem::recordings::checks
