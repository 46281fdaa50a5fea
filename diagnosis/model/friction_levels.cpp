#include "diagnosis/model/friction_levels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "pem/coupling/excite.hpp"
#include "pem/coupling/linearise.hpp"

namespace railpem::diagnosis {

namespace {

/// Takes in the velocities of a recording's elements.
template <std::size_t elements>
void take_in(const std::array<double, elements>& velocities, FrictionLevel& level) {
    const auto [least, most] = std::minmax_element(velocities.begin(), velocities.end());
    level.slowest_m_per_s = level.fastest_m_per_s == 0.0 ? *least : std::min(level.slowest_m_per_s, *least);
    level.fastest_m_per_s = std::max(level.fastest_m_per_s, *most);
}

pem::Linearisation linearisation_of(const pem::CaseParameters& parameters, double speed) {
    pem::CoupledModel model = pem::coupled_model(parameters, speed);
    return pem::linearise(parameters, pem::excitation_sources(parameters, model.wheels_m, speed), model);
}

}  // namespace

std::vector<FrictionLevel> friction_levels(const Trial& trial, const BelievedCase& believed,
                                           const std::vector<Observation>& observations) {
    FrictionLevel primary{.stage = Element::primary}, secondary{.stage = Element::secondary};
    for (const Observation& observation : observations) {
        if (observation.scalar || observation.speed_m_per_s == 0.0) continue;
        const pem::CaseParameters parameters = case_of(trial, believed, observation);
        const vehicle::SuspensionParameters &first = parameters.vehicle.primary, &second = parameters.vehicle.secondary;
        if (first.friction_force_n == 0.0 && second.friction_force_n == 0.0) continue;
        const pem::Linearisation own = linearisation_of(parameters, observation.speed_m_per_s);
        if (first.friction_force_n > 0.0) take_in(own.primary_velocity_m_per_s, primary);
        if (second.friction_force_n > 0.0) take_in(own.secondary_velocity_m_per_s, secondary);
    }
    std::vector<FrictionLevel> levels{primary, secondary};
    std::erase_if(levels, [](const FrictionLevel& own) { return own.fastest_m_per_s == 0.0; });
    return levels;
}

std::vector<std::string> said_of_friction(const std::vector<FrictionLevel>& levels) {
    std::vector<std::string> said;
    for (const FrictionLevel& own : levels) {
        const std::string slowest = fmt::format("{:.2g}", 1000.0 * own.slowest_m_per_s),
                          fastest = fmt::format("{:.2g}", 1000.0 * own.fastest_m_per_s);
        said.push_back(
            fmt::format("the friction of the {} suspension is known at velocities of {} mm/s (rms) across an element: "
                        "at lower and higher ones it may be another",
                        element_name(own.stage), slowest == fastest ? slowest : slowest + " to " + fastest));
    }
    return said;
}

}  // namespace railpem::diagnosis
