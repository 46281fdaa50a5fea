#include "diagnosis/hypotheses/corrections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <set>
#include <type_traits>

#include "diagnosis/observations/shows.hpp"
#include "pem/response_names.hpp"

namespace railpem::diagnosis {

namespace {

constexpr int kNodes = 7;  ///< of a correction: one an octave
/// two an octave: what hangs on a mass resonates in less than an octave (of an absorber on the axles, the place was the
/// contact)
constexpr int kNodesOfAMass = 13;
constexpr double kDeviation = 0.3;       ///< of a correction: what is left out moves a place by tens of percent
constexpr double kForceDeviation = 0.1;  ///< of the power of forces of its own, in multiples of the reference
constexpr std::size_t kForcePart = 2;    ///< behind real and imaginary part

/// The correction of a place of the structure, null for the others; of constant modifiers a constant one.
template <class Modifiers>
auto* structure_curve(Modifiers& modifiers, const CorrectionPlace& place) {
    using Curve = std::conditional_t<std::is_const_v<Modifiers>, const lanes::FactorCurve, lanes::FactorCurve>;
    Curve* none = nullptr;
    const std::size_t which = static_cast<std::size_t>(std::max(0, place.which - 1));
    if (place.attached) return none;
    switch (place.element) {
        case Element::secondary:
            return &modifiers.vehicle.secondary;
        case Element::primary:
            return &modifiers.vehicle.primary;
        case Element::body:
            return &modifiers.vehicle.body;
        case Element::bogie:
            return place.which == 0 ? &modifiers.vehicle.bogies : &modifiers.vehicle.one_bogie[which];
        case Element::wheel:
            return place.which == 0 ? &modifiers.vehicle.wheelsets : &modifiers.vehicle.one_wheelset[which];
        case Element::contact:
            return &modifiers.contact;
        case Element::rail:
            return &modifiers.track.rail;
        case Element::pad:
            return &modifiers.track.pads;
        case Element::support:
            return &modifiers.track.support;
        case Element::irregularity:
        case Element::sensor:
            break;
    }
    return none;
}

enum class Point { centre, front, rear };

std::string point_name(Point point) {
    return point == Point::centre ? "centre" : point == Point::front ? "front" : "rear";
}

template <class Car>
auto& attachments_of(Car& car, const CorrectionPlace& place) {
    return place.element == Element::body ? car.body_attachments : car.between_bogies;
}

lanes::FactorCurve& attached_curve(vehicle::VehicleModifiers& car, const CorrectionPlace& place, Point point) {
    vehicle::Attachments& own = attachments_of(car, place);
    return point == Point::centre ? own.centre : point == Point::front ? own.front : own.rear;
}

lanes::FactorCurve& curve_of(pem::Modifiers& modifiers, const CorrectionPlace& place) {
    if (lanes::FactorCurve* structure = structure_curve(modifiers, place)) return *structure;
    return modifiers.sensors[place.channel];
}

std::string channel_name(std::size_t response) {
    const std::string& where = pem::response_names()[response].where;
    if (where == "body") return "body_centre";
    return where.starts_with("wheel_") ? "axlebox_" + where.substr(6) : where;
}

/// A number of its own for one node of a curve. `nothing`: value of the curve without a correction.
Unknown curve_unknown(const std::string& where, Element element, const std::vector<double>& nodes, std::size_t node,
                      bool imaginary, double nothing, std::function<lanes::FactorCurve&(pem::Modifiers&)> curve_in) {
    return {
        .kind = UnknownKind::correction,
        .name = fmt::format("correction of {} at {:.3g} Hz, {}", where, nodes[node], imaginary ? "imaginary" : "real"),
        .deviation = kDeviation,
        .low = imaginary || nothing == 0.0 ? -5.0 : -0.95,
        .high = 5.0,
        .step = kBeliefs.number_step,
        .element = element,
        .set = [curve_in = std::move(curve_in), nodes, node, imaginary, nothing](Trial& trial, double x) {
            lanes::FactorCurve& curve = curve_in(trial.numbers.modifiers);
            if (curve.empty()) {
                curve.frequency_hz = nodes;
                curve.value.assign(nodes.size(), nothing);
            }
            const std::complex<double> own = curve.value[node];
            curve.value[node] =
                imaginary ? std::complex<double>(own.real(), x) : std::complex<double>(nothing + x, own.imag());
        }};
}

Unknown structure_unknown(const CorrectionPlace& place, const std::vector<double>& nodes, std::size_t node,
                          bool imaginary) {
    const std::string where = !place.channel.empty() ? place.channel
                                                     : element_name(place.element) +
                                                           (place.which == 0 ? "" : fmt::format(" {}", place.which));
    return curve_unknown(
        where, place.element, nodes, node, imaginary, 1.0,
        [place](pem::Modifiers& modifiers) -> lanes::FactorCurve& { return curve_of(modifiers, place); });
}

Unknown attached_unknown(const CorrectionPlace& place, Point point, const std::vector<double>& nodes, std::size_t node,
                         bool imaginary) {
    const std::string which = place.element == Element::body ? "body" : "bogies against each other";
    return curve_unknown(fmt::format("{}, {}", which, point_name(point)), place.element, nodes, node, imaginary, 0.0,
                         [place, point](pem::Modifiers& modifiers) -> lanes::FactorCurve& {
                             return attached_curve(modifiers.vehicle, place, point);
                         });
}

Unknown force_unknown(const CorrectionPlace& place, const std::vector<double>& nodes, std::size_t node) {
    return {.kind = UnknownKind::correction,
            .name = fmt::format("forces of {} at {:.3g} Hz", element_name(place.element), nodes[node]),
            .deviation = kForceDeviation,
            .low = 0.0,
            .high = 5.0,
            .step = kBeliefs.number_step,
            .element = place.element,
            .set = [element = place.element, nodes, node](Trial& trial, double x) {
                pem::Modifiers& modifiers = trial.numbers.modifiers;
                pem::ForceSpectrum& own =
                    element == Element::primary ? modifiers.primary_forces : modifiers.secondary_forces;
                if (own.empty()) {
                    own.frequency_hz = nodes;
                    own.share.assign(nodes.size(), 0.0);
                }
                own.share[node] = x;
            }};
}

/// It acts like an irregularity, and shares what that shares.
Unknown wheels_own_unknown(const std::vector<double>& nodes, std::size_t node) {
    return {.kind = UnknownKind::correction,
            .name = fmt::format("what wheels meet alone at {:.3g} Hz", nodes[node]),
            .deviation = kForceDeviation,
            .low = 0.0,
            .high = 5.0,
            .step = kBeliefs.number_step,
            .element = Element::irregularity,
            .set = [nodes, node](Trial& trial, double x) {
                pem::WheelsOwn& own = trial.numbers.modifiers.wheels_own;
                if (own.empty()) {
                    own.frequency_hz = nodes;
                    own.share.assign(nodes.size(), 0.0);
                }
                own.share[node] = x;
            }};
}

Unknown spectrum_unknown(const std::vector<double>& nodes, std::size_t node) {
    return {.kind = UnknownKind::correction,
            .name = fmt::format("correction of excitation at {:.3g} Hz", nodes[node]),
            .deviation = 2.0 * kDeviation,
            .low = -4.0,
            .high = 4.0,
            .step = kBeliefs.number_step,
            .element = Element::irregularity,
            .set = [nodes, node](Trial& trial, double x) {
                auto& spline = trial.numbers.irregularity.frequency_correction;
                if (spline.frequency_hz.empty()) {
                    spline.frequency_hz = nodes;
                    spline.log_factor.assign(nodes.size(), 0.0);
                }
                spline.log_factor[node] = x;
            }};
}

}  // namespace

bool is_wheels_own(const CorrectionPlace& place) {
    return place.forces && (place.element == Element::pad || place.element == Element::support);
}

std::complex<double> correction_at(const pem::CaseParameters& parameters, const CorrectionPlace& place, double omega) {
    if (!place.attached) {
        const lanes::FactorCurve* own = structure_curve(parameters.modifiers, place);
        return own ? own->at(omega) : 1.0;
    }
    std::complex<double> factor = 1.0;
    const vehicle::Attachments& own = attachments_of(parameters.modifiers.vehicle, place);
    for (const lanes::FactorCurve* curve : {&own.centre, &own.front, &own.rear})
        if (!curve->empty()) factor += curve->at(omega);
    return factor;
}

double correction_weight(const CorrectionPlace& place, std::size_t part, const std::vector<double>& nodes,
                         std::size_t node, double frequency_hz) {
    if (place.forces && part == (is_wheels_own(place) ? 0 : kForcePart))
        return pem::ForceSpectrum::weight(nodes, node, frequency_hz);
    if (place.element == Element::irregularity) {
        spectra::LogFrequencySpline own{nodes, std::vector<double>(nodes.size(), 0.0)};
        own.log_factor[node] = 1.0;
        return std::log(own.at(frequency_hz));
    }
    lanes::FactorCurve own{nodes, std::vector<std::complex<double>>(nodes.size(), 0.0)};
    own.value[node] = 1.0;
    return own.at(2.0 * std::numbers::pi * frequency_hz).real();
}

std::vector<double> correction_nodes(const CorrectionPlace& place, const std::vector<Observation>& observations) {
    double low = 1e300, high = 0.0;
    for (const Observation& observation : observations) {
        low = std::min(low, observation.expectation.low_hz);
        high = std::max(high, observation.expectation.high_hz);
    }
    std::vector<double> nodes;
    const bool is_mass = !place.attached && (place.element == Element::body || place.element == Element::bogie ||
                                             place.element == Element::wheel);
    const int count = is_mass ? kNodesOfAMass : kNodes;
    for (int i = 0; i < count; ++i) nodes.push_back(low * std::pow(high / low, static_cast<double>(i) / (count - 1)));
    return nodes;
}

std::vector<CorrectionPlace> correction_places(const BelievedCase& believed,
                                               const std::vector<Observation>& observations) {
    std::vector<CorrectionPlace> places;
    for (const Element element :
         {Element::secondary, Element::primary, Element::body, Element::bogie, Element::wheel, Element::contact,
          Element::rail, Element::pad, Element::support, Element::irregularity}) {
        if (std::none_of(observations.begin(), observations.end(),
                         [&](const Observation& own) { return reaches(own, element); }))
            continue;
        if (element == Element::support && believed.numbers.track.support.model == track::SupportModel::rigid) continue;
        const int count = element == Element::bogie ? 2 : element == Element::wheel ? 4 : 0;
        for (int which = 0; which <= count; ++which)
            places.push_back({.element = element, .channel = {}, .which = which});
        if (element == Element::body || element == Element::bogie)
            places.push_back({.element = element, .channel = {}, .attached = true});
        const auto is_series = [](const Observation& own) { return !own.scalar; };
        if ((element == Element::secondary || element == Element::primary || element == Element::pad) &&
            std::any_of(observations.begin(), observations.end(), is_series))
            places.push_back({.element = element, .channel = {}, .forces = true});
    }
    std::set<std::string> channels;
    for (const Observation& observation : observations)
        for (const ObservedChannel& channel : observation.channels)
            if (pem::response_names()[channel.response].where.find("rail") != 0)
                channels.insert(channel_name(channel.response));
    for (const std::string& channel : channels) places.push_back({.element = Element::sensor, .channel = channel});
    return places;
}

std::vector<Unknown> correction_unknowns(const CorrectionPlace& place, const std::vector<Observation>& observations) {
    const std::vector<double> nodes = correction_nodes(place, observations);
    std::vector<Unknown> unknowns;
    for (std::size_t node = 0; node < nodes.size(); ++node) {
        if (place.element == Element::irregularity) {
            unknowns.push_back(spectrum_unknown(nodes, node));
            continue;
        }
        if (is_wheels_own(place)) {
            unknowns.push_back(wheels_own_unknown(nodes, node));
            continue;
        }
        for (const bool imaginary : {false, true}) {
            if (!place.attached)
                unknowns.push_back(structure_unknown(place, nodes, node, imaginary));
            else
                for (const Point point : {Point::centre, Point::front, Point::rear})
                    unknowns.push_back(attached_unknown(place, point, nodes, node, imaginary));
        }
        if (place.forces) unknowns.push_back(force_unknown(place, nodes, node));
    }
    return unknowns;
}

}  // namespace railpem::diagnosis
