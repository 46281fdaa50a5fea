#include "diagnosis/corrections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <type_traits>

#include "diagnosis/shows.hpp"
#include "pem/solution.hpp"

namespace railpem::diagnosis {

namespace {

constexpr int kNodes = 7;              ///< of a correction: one an octave
constexpr double kDeviation = 0.3;     ///< of a correction: what is left out moves a place by tens of percent
constexpr double kStep = 1e-7;  ///< as of the numbers: what a correction shares with one has the same error

/// The correction of a place of the structure, null for the others; of a constant case a constant one.
template <class Case>
auto* structure_curve(Case& parameters, const CorrectionPlace& place) {
    using Curve = std::conditional_t<std::is_const_v<Case>, const lanes::FactorCurve, lanes::FactorCurve>;
    Curve* none = nullptr;
    const std::size_t which = static_cast<std::size_t>(std::max(0, place.which - 1));
    switch (place.element) {
        case Element::secondary: return &parameters.vehicle.secondary.correction;
        case Element::primary: return &parameters.vehicle.primary.correction;
        case Element::body: return &parameters.vehicle.body_correction;
        case Element::bogie: return place.which == 0 ? &parameters.vehicle.bogie_correction : &parameters.vehicle.one_bogie_correction[which];
        case Element::wheel: return place.which == 0 ? &parameters.vehicle.wheel_correction : &parameters.vehicle.one_wheelset_correction[which];
        case Element::contact: return &parameters.contact.correction;
        case Element::rail: return &parameters.track.rail.correction;
        case Element::pad: return &parameters.track.pads.correction;
        case Element::support: return &parameters.track.support.correction;
        case Element::irregularity: break;
        case Element::sensor: break;
    }
    return none;
}

lanes::FactorCurve& curve_of(pem::CaseParameters& parameters, const CorrectionPlace& place) {
    if (lanes::FactorCurve* structure = structure_curve(parameters, place)) return *structure;
    for (pem::SensorParameters& sensor : parameters.sensors)
        if (sensor.channel == place.channel) return sensor.correction;
    parameters.sensors.push_back({.channel = place.channel});
    return parameters.sensors.back().correction;
}

std::string channel_name(std::size_t response) {
    const std::string& where = pem::response_names()[response].where;
    if (where == "body") return "body_centre";
    return where.starts_with("wheel_") ? "axlebox_" + where.substr(6) : where;
}

Unknown structure_unknown(const CorrectionPlace& place, const std::vector<double>& nodes, std::size_t node, bool imaginary) {
    const std::string where = !place.channel.empty() ? place.channel : element_name(place.element) + (place.which == 0 ? "" : fmt::format(" {}", place.which));
    return {.kind = UnknownKind::correction,
            .name = fmt::format("correction of {} at {:.3g} Hz, {}", where, nodes[node], imaginary ? "imaginary" : "real"),
            .deviation = kDeviation,
            .low = imaginary ? -5.0 : -0.95,
            .high = 5.0,
            .step = kStep,
            .element = place.element,
            .set = [place, nodes, node, imaginary](Trial& trial, double x) {
                lanes::FactorCurve& curve = curve_of(trial.numbers, place);
                if (curve.empty()) {
                    curve.frequency_hz = nodes;
                    curve.value.assign(nodes.size(), 1.0);
                }
                const std::complex<double> own = curve.value[node];
                curve.value[node] = imaginary ? std::complex<double>(own.real(), x) : std::complex<double>(1.0 + x, own.imag());
            }};
}

Unknown spectrum_unknown(const std::vector<double>& nodes, std::size_t node) {
    return {.kind = UnknownKind::correction,
            .name = fmt::format("correction of excitation at {:.3g} Hz", nodes[node]),
            .deviation = 2.0 * kDeviation,
            .low = -4.0,
            .high = 4.0,
            .step = kStep,
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

const lanes::FactorCurve& correction_at(const pem::CaseParameters& parameters, const CorrectionPlace& place) {
    static const lanes::FactorCurve none;
    const lanes::FactorCurve* own = structure_curve(parameters, place);
    return own ? *own : none;
}

std::vector<double> correction_nodes(const std::vector<Observation>& observations) {
    double low = 1e300, high = 0.0;
    for (const Observation& observation : observations) {
        low = std::min(low, observation.expectation.low_hz);
        high = std::max(high, observation.expectation.high_hz);
    }
    std::vector<double> nodes;
    for (int i = 0; i < kNodes; ++i) nodes.push_back(low * std::pow(high / low, static_cast<double>(i) / (kNodes - 1)));
    return nodes;
}

std::vector<CorrectionPlace> correction_places(const BelievedCase& believed, const std::vector<Observation>& observations) {
    std::vector<CorrectionPlace> places;
    for (const Element element : {Element::secondary, Element::primary, Element::body, Element::bogie, Element::wheel, Element::contact,
                                  Element::rail, Element::pad, Element::support, Element::irregularity}) {
        if (std::none_of(observations.begin(), observations.end(), [&](const Observation& own) { return reaches(own, element); })) continue;
        if (element == Element::support && believed.numbers.track.support.model == track::SupportModel::rigid) continue;
        const int count = element == Element::bogie ? 2 : element == Element::wheel ? 4 : 0;
        for (int which = 0; which <= count; ++which) places.push_back({.element = element, .channel = {}, .which = which});
    }
    std::set<std::string> channels;
    for (const Observation& observation : observations)
        for (const ObservedChannel& channel : observation.channels)
            if (pem::response_names()[channel.response].where.find("rail") != 0) channels.insert(channel_name(channel.response));
    for (const std::string& channel : channels) places.push_back({.element = Element::sensor, .channel = channel});
    return places;
}

std::vector<Unknown> correction_unknowns(const CorrectionPlace& place, const std::vector<Observation>& observations) {
    const std::vector<double> nodes = correction_nodes(observations);
    std::vector<Unknown> unknowns;
    for (std::size_t node = 0; node < nodes.size(); ++node) {
        if (place.element == Element::irregularity) {
            unknowns.push_back(spectrum_unknown(nodes, node));
            continue;
        }
        unknowns.push_back(structure_unknown(place, nodes, node, false));
        unknowns.push_back(structure_unknown(place, nodes, node, true));
    }
    return unknowns;
}

}  // namespace railpem::diagnosis
