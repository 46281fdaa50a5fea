#include "diagnosis/judge/spoiled_values.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <span>

#include "diagnosis/likelihood/likelihood.hpp"
#include "diagnosis/likelihood/scalar_likelihood.hpp"
#include "parameters/parameter_error.hpp"

namespace railpem::diagnosis {

namespace {

using Complex = std::complex<double>;
using recordings::RecordingKind;

/// A factor that people lose, and what it usually is.
struct Slip {
    double factor;
    const char* often;
};

constexpr Slip kAmplitudeSlips[] = {{1.0, ""},
                                    {9.80665, "g for m/s^2, or a factor of ten"},
                                    {1e3, "mm for m, or kN for N"},
                                    {1e6, "um for m"},
                                    {1e9, "nm for m"}};
constexpr Slip kDecaySlips[] = {{1.0, ""}, {8.686, "nepers for dB, or a factor of ten"}, {1e3, "per km for per m"}};

constexpr double kLeastLevel = std::numbers::ln2;  ///< nepers of the recorded value that a slip of level moves at least
constexpr double kLeastPhase = 0.5;                ///< rad, the same of one that moves phases alone
constexpr double kRemoved = 0.75;                  ///< of the difference, that undoing a slip removes at least
/// Less that every further slip has to leave, a factor: most recordings have at most one. Chosen
constexpr double kForEachSlip = 1.5;

/// Values of one channel: logarithm of recorded over believed, and the frequency.
struct Residuals {
    std::vector<Complex> value;
    std::vector<double> frequency_hz;
    std::vector<double> recorded_phase;
    bool has_phase = false;
    double power = 1.0;  ///< of an amplitude factor in the value: 2 for power spectra
};

double wrapped(double angle) {
    return std::remainder(angle, 2.0 * std::numbers::pi);
}

/// What is left of a difference with a slip undone.
Complex undone(const Residuals& own, std::size_t i, const SpoiledChannel& slip) {
    const double omega = 2.0 * std::numbers::pi * own.frequency_hz[i];
    Complex left = own.value[i];
    // phase of recorded over believed; conjugated, the right recorded phase is the opposite
    if (slip.conjugated) left -= Complex(0.0, 2.0 * own.recorded_phase[i]);
    left -= own.power * std::log(std::abs(slip.factor)) + static_cast<double>(slip.derivatives) * std::log(omega);
    const double turn = 0.5 * std::numbers::pi * slip.derivatives + (slip.factor < 0.0 ? std::numbers::pi : 0.0);
    // what was turned before it was conjugated is turned the other way
    left -= Complex(0.0, slip.conjugated ? -turn : turn);
    return own.has_phase ? Complex(left.real(), wrapped(left.imag())) : Complex(left.real(), 0.0);
}

double rms_with(const Residuals& own, const SpoiledChannel& slip) {
    double sum = 0.0;
    for (std::size_t i = 0; i < own.value.size(); ++i) sum += std::norm(undone(own, i, slip));
    return std::sqrt(sum / static_cast<double>(own.value.size()));
}

std::string in_words(const SpoiledChannel& slip, const char* often) {
    std::vector<std::string> parts;
    if (slip.derivatives > 0) parts.push_back(slip.derivatives == 1 ? "it is a mobility" : "it is an accelerance");
    if (std::abs(slip.factor) != 1.0)
        parts.push_back(fmt::format("its values are {:.3g} times too {} ({})",
                                    std::abs(slip.factor) > 1.0 ? std::abs(slip.factor) : 1.0 / std::abs(slip.factor),
                                    std::abs(slip.factor) > 1.0 ? "large" : "small", often));
    if (slip.factor < 0.0) parts.emplace_back("its sign is inverted");
    if (slip.conjugated) parts.emplace_back("it is the complex conjugate: a driving point would give energy");
    return fmt::format("{} of {}: {}", slip.channel, slip.recording, fmt::join(parts, ", and "));
}

/// How many slips come together.
int count_of(const SpoiledChannel& slip) {
    return (std::abs(slip.factor) != 1.0) + (slip.factor < 0.0) + (slip.derivatives > 0) + slip.conjugated;
}

/// Tries one set of choices. Each further slip has to leave so much less.
void attempt(const Residuals& own, SpoiledChannel slip, const char* often, double& least, SpoiledChannel& best) {
    const double left = std::pow(kForEachSlip, count_of(slip)) * rms_with(own, slip);
    if (!(left < least)) return;
    slip.says = in_words(slip, often);
    least = left;
    best = slip;
}

SpoiledChannel best_slip(const Residuals& own, const SpoiledChannel& none, RecordingKind kind) {
    SpoiledChannel best = none;
    double least = rms_with(own, none);
    const bool receptance = kind == RecordingKind::receptance;
    const std::span<const Slip> slips =
        kind == RecordingKind::decay_rate ? std::span<const Slip>(kDecaySlips) : std::span<const Slip>(kAmplitudeSlips);
    for (const Slip& slip : slips)
        for (const double factor : {slip.factor, 1.0 / slip.factor})
            for (int derivatives = 0; derivatives <= (receptance ? 2 : 0); ++derivatives)
                for (const bool conjugated : {false, true})
                    for (const double sign : {1.0, -1.0}) {
                        if (!own.has_phase && (conjugated || sign < 0.0)) continue;
                        SpoiledChannel tried = none;
                        tried.factor = sign * factor;
                        tried.derivatives = derivatives;
                        tried.conjugated = conjugated;
                        attempt(own, tried, slip.often, least, best);
                    }
    return best;
}

Residuals residuals_of(const Observation& observation, const ExpectedSpectra& prediction, std::size_t channel) {
    const ScalarData& data = *observation.scalar;
    Residuals own{.has_phase = data.has_phase,
                  .power = data.kind == RecordingKind::psd || data.kind == RecordingKind::points ? 2.0 : 1.0};
    for (std::size_t i = 0; i < data.values.size(); ++i) {
        if (data.values[i].channel != channel || !std::isfinite(prediction.values[i].real())) continue;
        own.value.push_back(-prediction.values[i]);
        own.frequency_hz.push_back(data.values[i].frequency_hz);
        own.recorded_phase.push_back(data.values[i].log_value.imag());
    }
    return own;
}

/// The recorded values as they should have been written.
void undo(const SpoiledChannel& slip, std::size_t channel, double power, ScalarData& data) {
    for (ScalarValue& value : data.values) {
        if (value.channel != channel) continue;
        const double omega = 2.0 * std::numbers::pi * value.frequency_hz;
        const double shift = power * std::log(std::abs(slip.factor)) + slip.derivatives * std::log(omega);
        const double turn = 0.5 * std::numbers::pi * slip.derivatives + (slip.factor < 0.0 ? std::numbers::pi : 0.0);
        const double phase = (slip.conjugated ? -1.0 : 1.0) * value.log_value.imag() - turn;
        value.log_value = {value.log_value.real() - shift, data.has_phase ? wrapped(phase) : 0.0};
        value.pedestal *= std::exp(-shift);
    }
}

}  // namespace

std::vector<SpoiledChannel> undo_spoiling(const BelievedCase& believed, std::vector<Observation>& observations) {
    std::vector<SpoiledChannel> found;
    const Trial trial = believed_trial(believed, observations);
    const LikelihoodContext context{.believed = &believed, .observations = &observations, .part = Part::all};
    for (std::size_t o = 0; o < observations.size(); ++o) {
        Observation& observation = observations[o];
        if (!observation.scalar) continue;
        ScalarData& data = *observation.scalar;
        const ExpectedSpectra prediction = predict_one(trial, context, o);
        for (std::size_t c = 0; c < observation.channel_names.size(); ++c) {
            if (c < observation.unknown_scale.size() && observation.unknown_scale[c]) continue;
            const Residuals own = residuals_of(observation, prediction, c);
            if (own.value.empty()) continue;
            const SpoiledChannel none{.recording = observation.name, .channel = observation.channel_names[c]};
            const double before = rms_with(own, none);
            SpoiledChannel slip = best_slip(own, none, data.kind);
            const double left = rms_with(own, slip);
            const bool of_level = std::abs(slip.factor) != 1.0 || slip.derivatives > 0;
            if (left > (1.0 - kRemoved) * before || before < (of_level ? own.power * kLeastLevel : kLeastPhase))
                continue;
            slip.off_db = db_per_neper(data.kind) * before;
            slip.left_db = db_per_neper(data.kind) * left;
            undo(slip, c, own.power, data);
            found.push_back(std::move(slip));
        }
    }
    return found;
}

}  // namespace railpem::diagnosis
