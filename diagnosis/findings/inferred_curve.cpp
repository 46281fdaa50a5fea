#include "diagnosis/findings/inferred_curve.hpp"

#include <cmath>
#include <numbers>

#include "diagnosis/fit/interval.hpp"
#include "lanes/factor_curve.hpp"
#include "pem/contact.hpp"
#include "track/pads/pad_law.hpp"
#include "vehicle/half_vehicle.hpp"

namespace railpem::diagnosis {

namespace {

using Complex = std::complex<double>;
constexpr int kPoints = 60;

Complex pad_stiffness(const track::TrackParameters& track, double frequency_hz) {
    const track::PadParameters& pads = track.pads;
    const double k0 = pads.dynamic_to_static_ratio * pads.static_stiffness_n_per_m;
    return k0 * track::pad_shape(pads, frequency_hz) +
           Complex(0.0, 2.0 * std::numbers::pi * frequency_hz * track::pad_damping(pads));
}

Complex suspension(const vehicle::SuspensionParameters& law, double omega) {
    return vehicle::suspension_stiffness(law, 0.0, lanes::broadcast(omega))[0];
}

Complex corrected(const pem::CaseParameters& parameters, const CorrectionPlace& place, double frequency) {
    return place_law(parameters, place.element, frequency).value() *
           correction_at(parameters, place, 2.0 * std::numbers::pi * frequency);
}

bool moves_law(const Unknown& unknown) {
    return unknown.kind == UnknownKind::number || unknown.kind == UnknownKind::effect ||
           unknown.kind == UnknownKind::correction;
}

/// Derivatives of the corrected law at every frequency with the unknowns that move it: [unknown][frequency].
std::vector<std::vector<Complex>> law_slopes(const Fit& fit, const CorrectionPlace& place,
                                             const std::vector<double>& frequencies, const BelievedCase& believed,
                                             const Observation& observation) {
    std::vector<std::vector<Complex>> slopes(fit.unknowns.size());
    const pem::CaseParameters at = case_of(fit.trial, believed, observation);
    for (std::size_t u = 0; u < fit.unknowns.size(); ++u) {
        if (!moves_law(fit.unknowns[u])) continue;
        Trial moved = fit.trial;
        const double step = 1e-5;
        fit.unknowns[u].set(moved, fit.values[u] + step);
        const pem::CaseParameters with = case_of(moved, believed, observation);
        for (const double f : frequencies)
            slopes[u].push_back((corrected(with, place, f) - corrected(at, place, f)) / step);
    }
    return slopes;
}

}  // namespace

std::optional<Complex> place_law(const pem::CaseParameters& parameters, Element element, double frequency) {
    const double omega = 2.0 * std::numbers::pi * frequency;
    const vehicle::VehicleParameters& car = parameters.vehicle;
    switch (element) {
        case Element::secondary:
            return suspension(car.secondary, omega);
        case Element::primary:
            return suspension(car.primary, omega);
        case Element::body:
            return car.body_mass_kg + car.payload_kg;
        case Element::bogie:
            return car.bogie_mass_kg;
        case Element::wheel:
            return car.wheelset_mass_kg;
        case Element::rail:
            return parameters.track.rail.mass_kg_per_m;
        case Element::pad:
            return pad_stiffness(parameters.track, frequency);
        case Element::support: {
            const track::SupportParameters& support = parameters.track.support;
            return support.stiffness_n_per_m * Complex(1.0, support.loss_factor) +
                   Complex(0.0, omega * support.damping_n_s_per_m);
        }
        case Element::contact:
            return pem::contact_stiffness(pem::contact_constant(parameters.contact, car.wheel_radius_m),
                                          pem::wheel_load_n(parameters));
        case Element::irregularity:
        case Element::sensor:
            return std::nullopt;
    }
    return std::nullopt;
}

InferredCurve inferred_curve(const Fit& anonymous, const CorrectionPlace& place, const BelievedCase& believed,
                             const std::vector<Observation>& observations) {
    const Element element = place.element;
    InferredCurve curve{.element = element};
    const bool is_mass = element == Element::body || element == Element::bogie || element == Element::wheel;
    curve.unit = is_mass ? "kg" : element == Element::rail ? "kg/m" : "N/m";
    double low = 1e300, high = 0.0;
    for (const Observation& observation : observations) {
        low = std::min(low, observation.expectation.low_hz);
        high = std::max(high, observation.expectation.high_hz);
    }
    for (int i = 0; i < kPoints; ++i)
        curve.frequency_hz.push_back(low * std::pow(high / low, static_cast<double>(i) / (kPoints - 1)));
    const Observation& any = observations.front();
    const pem::CaseParameters parameters = case_of(anonymous.trial, believed, any);
    const std::vector<std::vector<Complex>> slopes = law_slopes(anonymous, place, curve.frequency_hz, believed, any);
    for (std::size_t i = 0; i < curve.frequency_hz.size(); ++i) {
        const Complex value = corrected(parameters, place, curve.frequency_hz[i]);
        double real = 0.0, imaginary = 0.0;
        for (std::size_t a = 0; a < slopes.size(); ++a)
            for (std::size_t b = 0; b < slopes.size(); ++b) {
                if (slopes[a].empty() || slopes[b].empty()) continue;
                const double covariance = anonymous.covariance(static_cast<long>(a), static_cast<long>(b));
                real += slopes[a][i].real() * slopes[b][i].real() * covariance;
                imaginary += slopes[a][i].imag() * slopes[b][i].imag() * covariance;
            }
        curve.value.push_back(value);
        curve.real_low.push_back(value.real() - kNinety * std::sqrt(std::max(0.0, real)));
        curve.real_high.push_back(value.real() + kNinety * std::sqrt(std::max(0.0, real)));
        curve.imaginary_low.push_back(value.imag() - kNinety * std::sqrt(std::max(0.0, imaginary)));
        curve.imaginary_high.push_back(value.imag() + kNinety * std::sqrt(std::max(0.0, imaginary)));
    }
    return curve;
}

std::vector<Complex> law_of(const Fit& fit, const InferredCurve& curve, const BelievedCase& believed,
                            const std::vector<Observation>& observations) {
    std::vector<Complex> values;
    const pem::CaseParameters parameters = case_of(fit.trial, believed, observations.front());
    for (const double f : curve.frequency_hz) values.push_back(place_law(parameters, curve.element, f).value_or(0.0));
    return values;
}

}  // namespace railpem::diagnosis
