#include "app/plausibility/implausible_case.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "app/plausibility/believed_ranges.hpp"
#include "app/plausibility/unit_slips.hpp"
#include "app/schema/case_numbers.hpp"
#include "app/schema/case_schema.hpp"
#include "app/schema/read_table.hpp"

namespace railpem::app {

namespace {

const BelievedRange* range_of(const std::vector<BelievedRange>& all, const std::string& key) {
    for (const BelievedRange& range : all)
        if (range.key == key) return &range;
    return nullptr;
}

std::string without_elements(const std::string& key) {
    std::vector<Step> steps = key_steps(key);
    for (Step& step : steps) step.element = 0;
    return key_text(steps);
}

std::string with_unit(double value, const std::string& unit) {
    return fmt::format("{:.4g}{}", value, unit == "1" || unit.empty() ? "" : " " + unit);
}

std::string sentence(const std::string& name, double value, const std::string& unit, const BelievedRange& range,
                     const std::string& slip) {
    return fmt::format("{} = {} is hardly believed: {}; {:g} to {:g} pass without a question{}", name,
                       with_unit(value, unit), range.reason, range.low, range.high, slip.empty() ? "" : "; " + slip);
}

void look_at(const std::string& key, double value, const std::string& unit, std::vector<Implausible>& found) {
    const BelievedRange* range = range_of(believed_ranges(), without_elements(key));
    if (!range || value == 0.0 || std::isinf(value) || (value >= range->low && value <= range->high)) return;
    found.push_back({key, sentence(key, value, unit, *range, likely_unit(value, unit, range->low, range->high))});
}

/// A figure with its unit and what probably went wrong where it is out of range.
struct Figure {
    std::string name;
    double value;
    std::string unit, slip;
};

std::vector<Figure> derived_figures(const pem::CaseParameters& parameters, const CaseFigures& figures) {
    const vehicle::VehicleParameters& car = parameters.vehicle;
    const auto radius = [](double inertia, double mass) { return std::sqrt(inertia / mass); };
    std::vector<Figure> all = {
        {"wheel load", figures.wheel_load_n, "N", "are the masses those of the whole vehicle, bogie and wheelset?"},
        {"mass of the body over that of a bogie", car.body_mass_kg / car.bogie_mass_kg, "1", "one of them in t?"},
        {"mass of a bogie over that of a wheelset", car.bogie_mass_kg / car.wheelset_mass_kg, "1", "one of them in t?"},
        {"radius of gyration of the body over the bogie distance",
         radius(car.body_pitch_inertia_kg_m2, car.body_mass_kg) / car.bogie_distance_m, "1",
         "the roll inertia, or t m^2?"},
        {"radius of gyration of a bogie over its wheelbase",
         radius(car.bogie_pitch_inertia_kg_m2, car.bogie_mass_kg) / car.wheelbase_m, "1", "the yaw inertia, or t m^2?"},
        {"static deflection of the secondary springs", figures.secondary_deflection_m, "m",
         "springs per bogie and rail side?"},
        {"static deflection of the primary springs", figures.primary_deflection_m, "m",
         "springs per axle box and rail side?"},
        {"largest pad compression", figures.largest_pad_compression_m, "m", "kN/mm for the pads, or a curve in mm?"}};
    std::map<std::string, bool> named;
    for (const pem::Resonance& resonance : figures.resonances)
        if (!named[resonance.name]) {
            named[resonance.name] = true;  // the lowest of its name: the others are coupled motions
            all.push_back({resonance.name, resonance.frequency_hz, "Hz", "a mass or a stiffness in another unit?"});
        }
    for (const CaseFigures::Excited& excited : figures.excited)
        if (excited.rms_m > 0.0)
            all.push_back({"rms of the irregularity", excited.rms_m, "m",
                           excited.rms_m > 1e-3 ? "a profile in mm, or a spectrum in mm^2 m?" : "a profile in km?"});
    return all;
}

}  // namespace

std::vector<Implausible> implausible_values(const pem::CaseParameters& parameters) {
    std::vector<Implausible> found;
    for (const CaseNumber& number : case_numbers(parameters))
        look_at(number.key, number.get(parameters), number.description.unit, found);
    for (const double speed : parameters.running.speeds_m_per_s) look_at("running.speeds_m_per_s", speed, "m/s", found);
    return found;
}

std::vector<Implausible> implausible_figures(const pem::CaseParameters& parameters, const CaseFigures& figures) {
    std::vector<Implausible> found;
    for (const Figure& figure : derived_figures(parameters, figures))
        for (Implausible& own : implausible_figure(figure.name, figure.value, figure.unit, figure.slip))
            found.push_back(std::move(own));
    return found;
}

std::vector<Implausible> implausible_figure(const std::string& name, double value, const std::string& unit,
                                            const std::string& slip) {
    const BelievedRange* range = range_of(believed_figures(), name);
    if (!range || (value >= range->low && value <= range->high)) return {};
    return {{"", sentence(name, value, unit, *range, slip)}};
}

std::vector<std::string> plausibility_warnings(const CaseFile& file, const CaseFigures& figures) {
    std::vector<Implausible> found = implausible_values(file.parameters);
    if (found.empty()) found = implausible_figures(file.parameters, figures);
    std::vector<std::string> warnings;
    for (const Implausible& own : found) {
        const Place place = own.key.empty() ? Place{} : place_of(file.document, own.key);
        std::string at = file.document.name;
        if (!place.option.empty())
            at = place.option;
        else if (place.line > 0)
            at += fmt::format(":{}:{}", place.line, place.column);
        warnings.push_back(at + ": " + own.says);
    }
    return warnings;
}

std::vector<std::string> sweep_warnings(const std::string& name, const pem::SweepPlan& plan) {
    std::vector<std::string> warnings;
    const auto add = [&](const pem::CaseParameters& parameters) {
        for (const Implausible& own : implausible_values(parameters))
            if (std::find(warnings.begin(), warnings.end(), name + ": " + own.says) == warnings.end())
                warnings.push_back(name + ": " + own.says);
    };
    add(plan.base);
    for (const pem::SweepAxis& axis : plan.axes) {
        pem::CaseParameters varied = plan.base;
        for (const double value :
             plan.design == pem::Design::latin_hypercube ? std::vector{axis.low, axis.high} : axis.values) {
            axis.set(varied, value);
            add(varied);
        }
    }
    return warnings;
}

void say_or_refuse(const std::vector<std::string>& warnings, bool strict) {
    if (warnings.empty()) return;
    if (strict)
        throw InputError(fmt::format("{}\nallowed: believed values, or without --strict", fmt::join(warnings, "\n")));
    for (const std::string& warning : warnings) fmt::print(stderr, "warning: {}\n", warning);
}

}  // namespace railpem::app
