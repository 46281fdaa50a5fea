#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "recordings/checks/checks.hpp"
#include "recordings/checks/median.hpp"
#include "recordings/units.hpp"

namespace railpem::recordings::checks {
namespace {

/// How far a sound case or a like channel may be off in level, dB, one standard deviation.
constexpr double level_scatter_db = 4.0;
/// Share of recordings whose unit is right, before looking.
constexpr double prior_right = 0.8;

struct UnitError {
    double factor;
    const char* says;
};

constexpr std::array<UnitError, 6> unit_errors = {
    {{standard_gravity_m_per_s2, "9.81 too high: numbers in m/s^2 taken for g"},
     {1.0 / standard_gravity_m_per_s2, "9.81 too low: numbers in g taken for m/s^2"},
     {1e3, "1000 too high: numbers in mm taken for m"},
     {1e-3, "1000 too low: numbers in m taken for mm"},
     {1e3 * standard_gravity_m_per_s2, "9810 too high"},
     {1e-3 / standard_gravity_m_per_s2, "9810 too low"}}};

/// The unit error that explains a level difference, with the probability that there is none.
const UnitError* explain(double level_db, double& probability_none) {
    const auto likelihood = [&](double expected) {
        return std::exp(-0.5 * std::pow((level_db - expected) / level_scatter_db, 2));
    };
    double total = prior_right * likelihood(0.0), best = 0.0;
    const double none = total;
    const UnitError* explanation = nullptr;
    for (const UnitError& error : unit_errors) {
        const double share = (1.0 - prior_right) / unit_errors.size() * likelihood(20.0 * std::log10(error.factor));
        total += share;
        if (share > best) {
            best = share;
            explanation = &error;
        }
    }
    probability_none = total > 0.0 ? none / total : 1.0;
    // Beyond four standard deviations of every explanation nothing is explained.
    return best > none && best > (1.0 - prior_right) / unit_errors.size() * std::exp(-8.0) ? explanation : nullptr;
}

double interpolated(const PredictedSpectrum& predicted, double f) {
    const auto& grid = predicted.frequency_hz;
    const auto above = std::lower_bound(grid.begin(), grid.end(), f);
    if (above == grid.begin() || above == grid.end()) return 0.0;
    const auto i = static_cast<std::size_t>(above - grid.begin());
    const double share = (f - grid[i - 1]) / (grid[i] - grid[i - 1]);
    return predicted.psd[i - 1] + share * (predicted.psd[i] - predicted.psd[i - 1]);
}

void against_prediction(const Evidence& evidence, std::size_t channel, std::vector<Fault>& faults) {
    const CrossSpectra& spectra = *evidence.spectra;
    const auto predicted =
        std::find_if(evidence.context.predicted.begin(), evidence.context.predicted.end(),
                     [&](const PredictedSpectrum& p) { return p.channel == evidence.name(channel); });
    if (predicted == evidence.context.predicted.end()) return;
    // Median over third-octave steps of the level difference, of the bands within 25 dB of the strongest predicted one:
    // a wrong peak does not move it, and bands that hold nothing but the sensor's noise do not count.
    std::vector<double> differences, weights;
    for (double centre = 2.0; centre < 0.4 * spectra.sampling_rate_hz; centre *= std::pow(10.0, 0.1)) {
        double measured = 0.0, expected = 0.0;
        for (std::size_t k = 1; k < spectra.bins(); ++k)
            if (spectra.frequency_hz[k] >= centre * std::pow(10.0, -0.05) &&
                spectra.frequency_hz[k] < centre * std::pow(10.0, 0.05)) {
                measured += spectra.psd(k, channel);
                expected += interpolated(*predicted, spectra.frequency_hz[k]);
            }
        if (measured <= 0.0 || expected <= 0.0) continue;
        differences.push_back(10.0 * std::log10(measured / expected));
        weights.push_back(expected);
    }
    if (differences.empty()) return;
    const double least = *std::max_element(weights.begin(), weights.end()) * std::pow(10.0, -2.5);
    std::vector<double> strong;
    for (std::size_t i = 0; i < weights.size(); ++i)
        if (weights[i] >= least) strong.push_back(differences[i]);
    if (strong.size() < 3) return;
    const double level = median(strong);
    double none = 1.0;
    const UnitError* error = explain(level, none);
    if (!error || none > 0.01) return;
    Fault found;
    found.kind = FaultKind::wrong_unit;
    found.severity = Severity::error;
    found.channels = {evidence.name(channel)};
    found.says = fmt::format("{:.1f} dB {} what the case predicts: most likely a factor {}", std::abs(level),
                             level > 0.0 ? "above" : "below", error->says);
    found.value = error->factor;
    found.unit = "1";
    found.false_alarm = none;
    faults.push_back(std::move(found));
}

/// Channels at the same kind of place differ by a few dB, not by 20 or 60.
void among_channels(const Evidence& evidence, std::vector<Fault>& faults) {
    const CrossSpectra& spectra = *evidence.spectra;
    for (std::size_t i = 0; i < spectra.size(); ++i) {
        const ChannelDescription& channel = spectra.channels[i];
        if (channel.location == Location::none) continue;
        std::vector<double> against;
        std::vector<std::string> names;
        for (std::size_t j = 0; j < spectra.size(); ++j) {
            const ChannelDescription& other = spectra.channels[j];
            if (j == i || other.location != channel.location || other.quantity != channel.quantity) continue;
            if (channel.location == Location::body &&
                std::abs(std::abs(other.position_m) - std::abs(channel.position_m)) > 1.0)
                continue;
            std::vector<double> differences;
            for (std::size_t k = 1; k < spectra.bins(); ++k)
                if (spectra.frequency_hz[k] > 1.0 && spectra.frequency_hz[k] < 0.3 * spectra.sampling_rate_hz &&
                    spectra.psd(k, i) > 0.0 && spectra.psd(k, j) > 0.0)
                    differences.push_back(10.0 * std::log10(spectra.psd(k, i) / spectra.psd(k, j)));
            if (differences.size() < 8) continue;
            against.push_back(median(differences));
            names.push_back(other.name);
        }
        if (against.empty()) continue;
        const double level = median(against);
        double none = 1.0;
        const UnitError* error = explain(level, none);
        // With one other channel it cannot be told which is wrong: said once, of the first.
        if (!error || none > 0.01 || (against.size() == 1 && level < 0.0)) continue;
        Fault found;
        found.kind = FaultKind::wrong_unit;
        found.severity = Severity::error;
        found.channels = {channel.name};
        if (against.size() == 1) found.channels.push_back(names[0]);
        found.says = against.size() == 1
                         ? fmt::format("{} is {:.1f} dB above {}: one of the two has a unit wrong by a factor {:.4g}",
                                       channel.name, level, names[0], error->factor)
                         : fmt::format("{:+.1f} dB against the other channels at such places: most likely a factor {}",
                                       level, error->says);
        found.value = error->factor;
        found.unit = "1";
        found.false_alarm = none;
        faults.push_back(std::move(found));
    }
}

}  // namespace

void check_unit(const Evidence& evidence, std::vector<Fault>& faults) {
    const auto is_said = [&](const std::string& name) {
        const auto& said = evidence.recording.contradictions;
        return std::any_of(said.begin(), said.end(), [&](const Fault& fault) {
            return fault.kind == FaultKind::unknown_scale &&
                   std::find(fault.channels.begin(), fault.channels.end(), name) != fault.channels.end();
        });
    };
    for (const Channel& channel : evidence.series().channels)
        if (channel.description.scale == Scale::unknown && !is_said(channel.description.name)) {
            Fault found;
            found.kind = FaultKind::unknown_scale;
            found.severity = Severity::note;
            found.channels = {channel.description.name};
            found.says =
                "the scale is stated to be unknown: shapes, ratios and frequencies can be judged, levels cannot";
            faults.push_back(std::move(found));
        }
    if (!evidence.spectra) return;
    for (std::size_t i = 0; i < evidence.spectra->size(); ++i)
        if (evidence.spectra->channels[i].scale == Scale::known) against_prediction(evidence, i, faults);
    among_channels(evidence, faults);
}

}  // namespace railpem::recordings::checks
