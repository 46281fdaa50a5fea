#include "recordings/checks/check_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "recordings/checks/interpolated.hpp"
#include "recordings/checks/level_mistake.hpp"
#include "recordings/checks/median.hpp"
#include "spectra/third_octaves.hpp"

namespace railpem::recordings::checks {
namespace {

Fault of_table(FaultKind kind, Severity severity, std::string says, double value, std::string unit) {
    Fault found;
    found.kind = kind;
    found.severity = severity;
    found.says = std::move(says);
    found.value = value;
    found.unit = std::move(unit);
    return found;
}

/// The centre nearest to a frequency among the names of third-octaves, their exact centres of base ten, and of base
/// two.
double nearest_centre(double frequency_hz) {
    const int index = static_cast<int>(std::lround(10.0 * std::log10(frequency_hz)));
    double nearest = 0.0;
    for (int i = index - 1; i <= index + 1; ++i) {
        const spectra::ThirdOctaveBand band = spectra::third_octave_band(i);
        for (const double centre : {band.nominal_hz, band.centre_hz, 1000.0 * std::exp2((i - 30) / 3.0)})
            if (std::abs(centre - frequency_hz) < std::abs(nearest - frequency_hz)) nearest = centre;
    }
    return nearest;
}

void check_centres(const MeasuredDecayRate& measured, std::vector<Fault>& faults) {
    constexpr double kRounding = 0.005;  // three digits of a centre
    std::size_t off = 0;
    double worst = 0.0, at = 0.0;
    for (const double centre : measured.centre_hz) {
        const double apart = centre / nearest_centre(centre) - 1.0;
        if (std::abs(apart) <= kRounding) continue;
        ++off;
        if (std::abs(apart) <= std::abs(worst)) continue;
        worst = apart;
        at = centre;
    }
    if (off == 0) return;
    faults.push_back(of_table(
        FaultKind::band_centres, Severity::warning,
        fmt::format("{} of {} centres are none of a third-octave, {:g} Hz is {:.1f} % off {:g} Hz: they are compared "
                    "with bands about the numbers that are given",
                    off, measured.centre_hz.size(), at, 100.0 * worst, nearest_centre(at)),
        worst, "1"));
}

}  // namespace

void check_decay_rate(const Recording& recording, const InspectionContext& context, std::vector<Fault>& faults) {
    const MeasuredDecayRate& measured = recording.decay_rate;
    if (measured.centre_hz.empty()) return;
    check_centres(measured, faults);
    // Without a case: rates of measured tracks lie between 0.1 and 30 dB/m (EN 15461; Jones, Thompson & Diehl 2006).
    constexpr double kUsual_db_per_m = 2.0, kUsualRatio = 30.0, kCaseRatio = 10.0;
    const bool has_case = !context.track.centre_hz.empty();
    std::vector<double> ratios;
    for (std::size_t i = 0; i < measured.centre_hz.size(); ++i) {
        const double expected =
            has_case ? interpolated(context.track.centre_hz, context.track.decay_rate_db_per_m, measured.centre_hz[i])
                     : kUsual_db_per_m;
        if (expected > 0.0 && measured.decay_rate_db_per_m[i] > 0.0)
            ratios.push_back(measured.decay_rate_db_per_m[i] / expected);
    }
    if (ratios.empty()) return;
    const double ratio = median(ratios), most = has_case ? kCaseRatio : kUsualRatio;
    if (ratio < most && ratio > 1.0 / most) return;
    faults.push_back(
        of_table(FaultKind::wrong_unit, Severity::warning,
                 fmt::format("the rates are {:.3g} times as {} {}{}", ratio > 1.0 ? ratio : 1.0 / ratio,
                             ratio > 1.0 ? "high as" : "low as",
                             has_case ? "the case predicts" : fmt::format("the usual {:g} dB/m", kUsual_db_per_m),
                             ratio > 300.0 ? ": most likely dB/km" : ""),
                 ratio, "1"));
}

void check_spectra(const Recording& recording, const InspectionContext& context, std::vector<Fault>& faults) {
    for (const ChannelSpectrum& measured : recording.spectra) {
        if (measured.description.scale == Scale::unknown) continue;
        const auto predicted =
            std::find_if(context.predicted.begin(), context.predicted.end(),
                         [&](const PredictedSpectrum& p) { return p.channel == measured.description.name; });
        if (predicted == context.predicted.end()) continue;
        LevelDifferences differences;
        std::vector<double> weights;
        for (std::size_t i = 0; i < measured.frequency_hz.size(); ++i) {
            const double expected = interpolated(predicted->frequency_hz, predicted->psd, measured.frequency_hz[i]);
            if (expected <= 0.0 || measured.psd[i] <= 0.0) continue;
            differences.frequency_hz.push_back(measured.frequency_hz[i]);
            differences.level_db.push_back(10.0 * std::log10(measured.psd[i] / expected));
            weights.push_back(expected);
        }
        if (weights.empty()) continue;
        const double least = *std::max_element(weights.begin(), weights.end()) * std::pow(10.0, -2.5);
        for (const double weight : weights) differences.strong.push_back(weight >= least);
        const auto mistake = level_mistake(differences);
        if (!mistake) continue;
        faults.push_back(of_table(FaultKind::wrong_unit, Severity::error,
                                  fmt::format("{:.1f} dB {} what the case predicts: most likely {}{}",
                                              std::abs(mistake->level_db), mistake->level_db > 0.0 ? "above" : "below",
                                              mistake->derivatives == 0 ? "" : "not its quantity, but ", mistake->says),
                                  mistake->factor, "1"));
        faults.back().channels = {measured.description.name};
    }
}

std::vector<Fault> check_tables(const Recording& recording, const InspectionContext& context) {
    std::vector<Fault> faults;
    check_spectra(recording, context, faults);
    check_receptance(recording, context, faults);
    check_decay_rate(recording, context, faults);
    return faults;
}

}  // namespace railpem::recordings::checks
