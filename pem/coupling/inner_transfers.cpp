#include "pem/coupling/inner_transfers.hpp"

#include <algorithm>
#include <cassert>

#include "pem/response_names.hpp"

namespace railpem::pem {

namespace {

std::size_t elements_of(vehicle::Law law) {
    assert(law == vehicle::Law::primary || law == vehicle::Law::secondary);
    return law == vehicle::Law::primary ? 4 : 2;
}

/// What the wheels' places, moved by a force in the vehicle, ask of the contacts: a wheel that is lifted meets a lower
/// rail.
template <typename Moved>
WheelVector moved_away(const Moved& moved) {
    WheelVector away;
    for (std::size_t wheel = 0; wheel < 4; ++wheel)
        away[wheel] = -moved[static_cast<std::size_t>(vehicle::Place::wheel_1) + wheel];
    return away;
}

}  // namespace

InnerTransfers inner_transfers(const CoupledModel& model, vehicle::Law law, double from_hz, double step_hz,
                               std::size_t lines, const std::vector<std::size_t>& kept,
                               const std::vector<RailGroup>& rails) {
    const std::size_t elements = elements_of(law);
    InnerTransfers result{.from_hz = from_hz,
                          .step_hz = step_hz,
                          .lines = lines,
                          .responses = kept.size(),
                          .elements = elements,
                          .values = {}};
    result.values.resize(lines * kept.size() * elements);
    CoupledWorkspace workspace(model);
    std::vector<lanes::Complex> all(response_names().size());
    for (std::size_t group = 0; group < rails.size(); ++group) {
        const GroupSolution& solution = solve_group(model, rails[group], workspace);
        for (std::size_t e = 0; e < elements; ++e) {
            const auto moved = vehicle::element_receptance(model.car, law, static_cast<int>(e), workspace.car);
            responses(solution, moved_away(moved), all.data());
            for (std::size_t place = 0; place < moved.size(); ++place)
                all[place] += moved[place] * (-solution.omega * solution.omega);
            for (std::size_t lane = 0; lane < lanes::width && group * lanes::width + lane < lines; ++lane)
                for (std::size_t r = 0; r < kept.size(); ++r)
                    result.values[((group * lanes::width + lane) * kept.size() + r) * elements + e] =
                        all[kept[r]][static_cast<int>(lane)];
        }
    }
    return result;
}

namespace {

/// Elongations of all elements by contact forces, beside what they are without.
void add_elongations(const GroupSolution& solution, vehicle::Law law, const WheelVector& forces,
                     std::vector<lanes::Complex>& elongations) {
    for (std::size_t e = 0; e < elongations.size(); ++e)
        for (std::size_t wheel = 0; wheel < 4; ++wheel)
            elongations[e] +=
                (law == vehicle::Law::primary ? solution.car.primary[e][wheel] : solution.car.secondary[e][wheel]) *
                forces[wheel];
}

/// By a unit force in an element.
std::vector<lanes::Complex> elongations_by(const CoupledModel& model, const GroupSolution& solution, vehicle::Law law,
                                           std::size_t forced, vehicle::Workspace& car) {
    const auto moved = vehicle::element_receptance(model.car, law, static_cast<int>(forced), car);
    std::vector<lanes::Complex> elongations(elements_of(law));
    for (std::size_t e = 0; e < elongations.size(); ++e)
        for (const vehicle::Share& share :
             law == vehicle::Law::primary ? model.car.primary_elongation[e] : model.car.secondary_elongation[e])
            elongations[e] += lanes::Complex(share.weight) * car.displacement[static_cast<std::size_t>(share.degree)];
    add_elongations(solution, law, contact_forces(solution, moved_away(moved)), elongations);
    return elongations;
}

/// Writes velocities into column `column` of the matrices of a group's lines, `columns` wide.
void write_velocities(const std::vector<lanes::Complex>& elongations, const lanes::Real& omega, std::size_t first,
                      std::size_t lines, std::size_t column, std::size_t columns,
                      std::vector<std::complex<double>>& values) {
    for (std::size_t lane = 0; lane < lanes::width && first + lane < lines; ++lane)
        for (std::size_t e = 0; e < elongations.size(); ++e) {
            const int at = static_cast<int>(lane);
            values[((first + lane) * elongations.size() + e) * columns + column] =
                std::complex<double>(0.0, omega[at]) * elongations[e][at];
        }
}

}  // namespace

ElementTransfers element_transfers(const CoupledModel& model, vehicle::Law law, double from_hz, double step_hz,
                                   std::size_t lines, const std::vector<RailGroup>& rails) {
    const std::size_t n = elements_of(law);
    ElementTransfers result{
        .from_hz = from_hz, .step_hz = step_hz, .lines = lines, .elements = n, .mobility = {}, .by_wheel = {}};
    result.mobility.resize(lines * n * n);
    result.by_wheel.resize(lines * n * 4);
    CoupledWorkspace workspace(model);
    for (std::size_t group = 0; group < rails.size(); ++group) {
        const GroupSolution& solution = solve_group(model, rails[group], workspace);
        const std::size_t first = group * lanes::width;
        for (std::size_t e = 0; e < n; ++e)
            write_velocities(elongations_by(model, solution, law, e, workspace.car), rails[group].omega, first, lines,
                             e, n, result.mobility);
        for (std::size_t wheel = 0; wheel < 4; ++wheel) {
            WheelVector unit;
            unit[wheel] = lanes::Complex(1.0);
            std::vector<lanes::Complex> elongations(n);
            add_elongations(solution, law, contact_forces(solution, unit), elongations);
            write_velocities(elongations, rails[group].omega, first, lines, wheel, 4, result.by_wheel);
        }
    }
    return result;
}

}  // namespace railpem::pem
