#include "diagnosis/friction_levels.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "pem/linearise.hpp"

namespace railpem::diagnosis {

namespace {

void take_in(const double* begin, const double* end, FrictionLevel& level) {
    const auto [least, most] = std::minmax_element(begin, end);
    level.slowest_m_per_s = level.fastest_m_per_s == 0.0 ? *least : std::min(level.slowest_m_per_s, *least);
    level.fastest_m_per_s = std::max(level.fastest_m_per_s, *most);
}

pem::Linearisation linearisation_of(const pem::CaseParameters& parameters, double speed) {
    pem::CoupledModel model = pem::coupled_model(parameters, speed);
    return pem::linearise(parameters, pem::excitation_sources(parameters, model.wheels_m, speed), model);
}

}  // namespace

std::vector<FrictionLevel> friction_levels(const Trial& trial, const BelievedCase& believed, const std::vector<Observation>& observations) {
    FrictionLevel primary{.stage = Element::primary}, secondary{.stage = Element::secondary};
    for (const Observation& observation : observations) {
        if (observation.scalar || observation.speed_m_per_s == 0.0) continue;
        const pem::CaseParameters parameters = case_of(trial, believed, observation);
        const double first = parameters.vehicle.primary.friction_force_n, second = parameters.vehicle.secondary.friction_force_n;
        if (first == 0.0 && second == 0.0) continue;
        const pem::Linearisation own = linearisation_of(parameters, observation.speed_m_per_s);
        if (first > 0.0) take_in(own.primary_velocity_m_per_s.begin(), own.primary_velocity_m_per_s.end(), primary);
        if (second > 0.0) take_in(own.secondary_velocity_m_per_s.begin(), own.secondary_velocity_m_per_s.end(), secondary);
    }
    std::vector<FrictionLevel> levels{primary, secondary};
    std::erase_if(levels, [](const FrictionLevel& own) { return own.fastest_m_per_s == 0.0; });
    return levels;
}

std::vector<std::string> said_of_friction(const std::vector<FrictionLevel>& levels) {
    std::vector<std::string> said;
    for (const FrictionLevel& own : levels)
        said.push_back(fmt::format("the friction of the {} suspension is known at velocities of {:.2g} to {:.2g} mm/s (rms) across an element: at lower and higher ones it may be another", element_name(own.stage),
                                   1000.0 * own.slowest_m_per_s, 1000.0 * own.fastest_m_per_s));
    return said;
}

}  // namespace railpem::diagnosis
