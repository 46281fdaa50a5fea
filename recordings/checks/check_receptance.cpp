#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "recordings/checks/check_tables.hpp"
#include "recordings/checks/interpolated.hpp"
#include "recordings/checks/median.hpp"
#include "recordings/checks/track_quantity.hpp"

namespace railpem::recordings::checks {
namespace {

using Complex = std::complex<double>;

/// Receptance of a rail on its seats without a case, m/N: a beam on springs, level up to its resonance and then falling
/// with f^-1.5. From soft to hard pads tracks lie within ± 20 dB of it (Thompson, Railway Noise and Vibration, 2009,
/// chapter 3).
double usual_receptance(double frequency_hz) {
    constexpr double kLevel_m_per_n = 1e-8, kResonance_hz = 300.0;
    return kLevel_m_per_n / (1.0 + std::pow(frequency_hz / kResonance_hz, 1.5));
}
constexpr double kUsualScatter_db = 12.0;
/// Of a case: soft and hard pads, and ballast or none, make two and a half in receptance.
constexpr double kCaseScatter_db = 8.0;

Fault of_receptance(FaultKind kind, Severity severity, std::string says, double value, std::string unit) {
    Fault found;
    found.kind = kind;
    found.severity = severity;
    found.says = std::move(says);
    found.value = value;
    found.unit = std::move(unit);
    return found;
}

/// Size and slope; the quantity that the values are.
TrackQuantity check_quantity(const MeasuredReceptance& measured, const PredictedTrack& track,
                             std::vector<Fault>& faults) {
    const bool has_case = !track.frequency_hz.empty();
    std::vector<double> magnitude, expected;
    for (std::size_t i = 0; i < measured.frequency_hz.size(); ++i) {
        magnitude.push_back(std::abs(measured.value_m_per_n[i]));
        expected.push_back(has_case
                               ? interpolated(track.frequency_hz, track.receptance_m_per_n, measured.frequency_hz[i])
                               : usual_receptance(measured.frequency_hz[i]));
    }
    const double scatter = has_case ? kCaseScatter_db : kUsualScatter_db;
    TrackQuantity quantity = track_quantity(measured.frequency_hz, magnitude, expected, scatter);
    const char* against = has_case ? "the case predicts" : "tracks have";
    if (!quantity.says.empty())
        faults.push_back(of_receptance(
            FaultKind::wrong_unit, Severity::error,
            fmt::format("the values are {:.0f} dB {} the receptance that {}: by size and slope most likely {}",
                        std::abs(quantity.level_db), quantity.level_db > 0.0 ? "above" : "below", against,
                        quantity.says),
            quantity.level_db, "dB"));
    else if (std::abs(quantity.level_db) > 3.0 * scatter)
        faults.push_back(of_receptance(
            FaultKind::wrong_unit, Severity::warning,
            fmt::format("the values are {:.0f} dB {} the receptance that {}, and no mistake "
                        "of unit or quantity explains it",
                        std::abs(quantity.level_db), quantity.level_db > 0.0 ? "above" : "below", against),
            quantity.level_db, "dB"));
    return quantity;
}

/// The values as a receptance, whatever derivative they are.
std::vector<Complex> as_receptance(const MeasuredReceptance& measured, int derivatives) {
    std::vector<Complex> values;
    for (std::size_t i = 0; i < measured.frequency_hz.size(); ++i)
        values.push_back(measured.value_m_per_n[i] /
                         std::pow(Complex(0.0, 2.0 * std::numbers::pi * measured.frequency_hz[i]), derivatives));
    return values;
}

/// +1: a spring at the lowest frequencies, −1: the opposite of one, 0: they lie above the resonance.
int spring_sign(const std::vector<double>& frequency_hz, const std::vector<Complex>& values) {
    constexpr double kBelow = 0.6;  // of the resonance: there a spring's share is the larger one
    const auto largest = std::max_element(values.begin(), values.end(),
                                          [](const Complex& a, const Complex& b) { return std::abs(a) < std::abs(b); });
    const double resonance = frequency_hz[static_cast<std::size_t>(largest - values.begin())];
    double sum = 0.0, whole = 0.0;
    for (std::size_t i = 0; i < values.size() && frequency_hz[i] < kBelow * resonance; ++i) {
        sum += values[i].real();
        whole += std::abs(values[i]);
    }
    return whole == 0.0 || std::abs(sum) < 0.5 * whole ? 0 : sum > 0.0 ? 1 : -1;
}

/// A driving point takes energy at every frequency.
void check_energy(const MeasuredReceptance& measured, int derivatives, std::vector<Fault>& faults) {
    constexpr double kMost = 0.5, kNoticed = 0.1;  // shares of |Im|: noise turns single values, a sign turns all
    const std::vector<Complex> values = as_receptance(measured, derivatives);
    double given = 0.0, whole = 0.0;
    for (const Complex& value : values) {
        given += std::max(0.0, value.imag());
        whole += std::abs(value.imag());
    }
    const double share = whole > 0.0 ? given / whole : 0.0;
    const int spring = spring_sign(measured.frequency_hz, values);
    const std::string gives =
        fmt::format("the track gives energy where it is struck: Im > 0 in {:.0f} % of it", 100.0 * share);
    if (share > kMost && spring < 0)
        faults.push_back(of_receptance(
            FaultKind::inverted, Severity::error,
            gives + ", and Re < 0 below the resonance: the sign of the force or of the response is turned", share,
            "1"));
    else if (share > kMost)
        faults.push_back(of_receptance(FaultKind::not_causal, Severity::error,
                                       gives + (spring > 0 ? ": the values are conjugated (time factor e^-iwt)"
                                                           : ": the values are conjugated (time factor e^-iwt), or "
                                                             "their sign is turned"),
                                       share, "1"));
    else if (spring < 0)
        faults.push_back(of_receptance(FaultKind::not_causal, Severity::error,
                                       "Re < 0 below the resonance, where a track is a spring: the sign is turned, and "
                                       "the values are conjugated (time factor e^-iwt)",
                                       share, "1"));
    else if (share > kNoticed)
        faults.push_back(of_receptance(FaultKind::not_causal, Severity::warning,
                                       gives + ": phases there cannot be relied on", share, "1"));
}

}  // namespace

void check_receptance(const Recording& recording, const InspectionContext& context, std::vector<Fault>& faults) {
    const MeasuredReceptance& measured = recording.receptance;
    if (measured.frequency_hz.empty()) return;
    const TrackQuantity quantity = check_quantity(measured, context.track, faults);
    if (measured.has_phase) check_energy(measured, quantity.derivatives, faults);
}

}  // namespace railpem::recordings::checks
