#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "recordings/checks/checks.hpp"
#include "recordings/checks/median.hpp"
#include "recordings/checks/prediction_levels.hpp"

namespace railpem::recordings::checks {
namespace {

/// Above which frequency a channel is silent, and by how much it falls or falls short there.
struct Limit {
    double frequency_hz = 0.0, fall_db = 0.0;
};

constexpr std::size_t octave = 3;  ///< bands

constexpr double kAgrees_db = 10.0, kSilent_db = -15.0;

/// The first band of those that are silent: what lies below agrees with the prediction, and what is strong above does
/// not, in as many bands as possible.
std::size_t first_silent(const LevelDifferences& differences) {
    const std::vector<double>& level = differences.level_db;
    int best = -1;
    std::size_t first = level.size();
    for (std::size_t split = 0; split <= level.size(); ++split) {
        int score = 0;
        for (std::size_t i = 0; i < level.size(); ++i) {
            if (i < split)
                score += std::abs(level[i]) <= kAgrees_db ? 1 : level[i] < kSilent_db ? -1 : 0;
            else if (differences.strong[i])
                score += level[i] < kSilent_db ? 1 : -1;
        }
        if (score <= best) continue;
        best = score;
        first = split;
    }
    return first;
}

/// Against the prediction: as expected up to a frequency, and nowhere above it; an octave above it 20 dB low.
std::optional<Limit> limit_by_prediction(const LevelDifferences& differences) {
    constexpr double kOctaveAbove_db = -20.0, kNearlyAll = 0.7;
    const std::vector<double>& level = differences.level_db;
    const std::size_t first = first_silent(differences);
    std::size_t agree = 0, silent = 0;
    std::vector<double> above, octave_above;
    for (std::size_t i = 0; i < level.size(); ++i) {
        if (i < first) {
            agree += std::abs(level[i]) <= kAgrees_db ? 1 : 0;
        } else if (differences.strong[i]) {
            above.push_back(level[i]);
            silent += level[i] < kSilent_db ? 1 : 0;
            if (i >= first + octave) octave_above.push_back(level[i]);
        }
    }
    if (agree < octave || static_cast<double>(agree) < kNearlyAll * static_cast<double>(first)) return std::nullopt;
    if (silent < octave || static_cast<double>(silent) < kNearlyAll * static_cast<double>(above.size()))
        return std::nullopt;
    if (octave_above.empty() || median(octave_above) > kOctaveAbove_db) return std::nullopt;
    constexpr double kEdge_db = -6.0;  // a band whose half a filter has taken
    std::size_t edge = first;
    while (edge > 0 && level[edge - 1] < kEdge_db) --edge;
    return Limit{differences.frequency_hz[edge] * std::pow(10.0, -0.05), -median(above)};
}

/// By itself: a fall of 40 dB within an octave, as no wheel, bogie or body has, below a quarter of half the sampling
/// rate, with nothing above it again.
std::optional<Limit> limit_by_shape(const CrossSpectra& spectra, std::size_t channel) {
    constexpr double kFall_db = 40.0, kNothing_db = 35.0, kFilter = 0.125;
    std::vector<double> centre, level;
    const double step = std::pow(10.0, 0.1), edge = std::pow(10.0, 0.05);
    for (double f = 2.0; f < 0.4 * spectra.sampling_rate_hz; f *= step) {
        std::vector<double> band;
        for (std::size_t k = 1; k < spectra.bins(); ++k)
            if (spectra.frequency_hz[k] >= f / edge && spectra.frequency_hz[k] < f * edge)
                band.push_back(spectra.psd(k, channel));
        if (band.empty() || median(band) <= 0.0) return std::nullopt;
        centre.push_back(f);
        level.push_back(10.0 * std::log10(median(band)));
    }
    for (std::size_t i = 0; i + octave < level.size() && centre[i] < kFilter * spectra.sampling_rate_hz; ++i) {
        if (level[i] - level[i + octave] < kFall_db) continue;
        const double loudest = *std::max_element(level.begin() + static_cast<std::ptrdiff_t>(i + octave), level.end());
        if (level[i] - loudest > kNothing_db) return Limit{centre[i] * edge, level[i] - level[i + octave]};
    }
    return std::nullopt;
}

Fault band_limited(std::vector<std::string> channels, const Limit& limit, double half_rate_hz, std::string says) {
    Fault found;
    found.kind = FaultKind::band_limited;
    found.severity = Severity::warning;
    found.channels = std::move(channels);
    found.says = std::move(says);
    found.low_hz = limit.frequency_hz;
    found.high_hz = half_rate_hz;
    found.value = limit.frequency_hz;
    found.unit = "Hz";
    found.false_alarm = false_alarm;
    return found;
}

/// Of limits that several channels have the middle one.
Limit middle(const std::vector<Limit>& limits) {
    std::vector<double> frequency, fall;
    for (const Limit& limit : limits) {
        frequency.push_back(limit.frequency_hz);
        fall.push_back(limit.fall_db);
    }
    return {median(frequency), median(fall)};
}

}  // namespace

void check_band_limit(const Evidence& evidence, std::vector<Fault>& faults) {
    if (!evidence.spectra) return;
    const CrossSpectra& spectra = *evidence.spectra;
    const double half_rate = 0.5 * spectra.sampling_rate_hz;
    std::vector<std::string> names, steep;
    std::vector<Limit> limits, falls;
    for (std::size_t i = 0; i < spectra.size(); ++i) {
        if (const auto limit = limit_by_prediction(against_prediction(evidence, i))) {
            names.push_back(evidence.name(i));
            limits.push_back(*limit);
        }
        if (const auto fall = limit_by_shape(spectra, i)) {
            steep.push_back(evidence.name(i));
            falls.push_back(*fall);
        }
    }
    if (!limits.empty()) {
        // What a filter has done to some channels it did to those that the case says nothing of there.
        for (std::size_t i = 0; i < steep.size(); ++i)
            if (std::find(names.begin(), names.end(), steep[i]) == names.end()) names.push_back(steep[i]);
        const Limit limit = middle(limits);
        faults.push_back(band_limited(
            names, limit, half_rate,
            fmt::format("above {:.3g} Hz there is no signal: {:.0f} dB below what the case predicts, and as predicted "
                        "below it: a low-pass filter",
                        limit.frequency_hz, limit.fall_db)));
        return;
    }
    // One channel may fall steeply by its place; a filter makes all fall at the same frequency.
    if (falls.size() < spectra.size() || falls.empty()) return;
    const Limit limit = middle(falls);
    for (const Limit& fall : falls)
        if (std::abs(std::log10(fall.frequency_hz / limit.frequency_hz)) > 0.15) return;
    faults.push_back(
        band_limited(steep, limit, half_rate,
                     fmt::format("above {:.3g} Hz there is no signal in any channel: {:.0f} dB less within "
                                 "an octave: a low-pass filter",
                                 limit.frequency_hz, limit.fall_db)));
}

}  // namespace railpem::recordings::checks
