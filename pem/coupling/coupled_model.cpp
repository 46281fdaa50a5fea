#include "pem/coupling/coupled_model.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "pem/contact.hpp"
#include "pem/rail/case_equilibrium.hpp"
#include "pem/rail/make_rail.hpp"

namespace railpem::pem {

using lanes::Complex;

CoupledModel coupled_model(const CaseParameters& parameters, double speed_m_per_s) {
    const track::StaticEquilibrium equilibrium = case_equilibrium(parameters);
    CoupledModel model = coupled_model(
        parameters, make_rail(parameters, vehicle::wheel_positions(parameters.vehicle), equilibrium, speed_m_per_s));
    if (parameters.track.pads.preload_strength > 0.0) model.warnings = equilibrium.warnings;
    return model;
}

CoupledModel coupled_model(const CaseParameters& parameters, std::shared_ptr<const RailModel> rail) {
    CoupledModel model;
    model.car = vehicle::half_vehicle(parameters.vehicle, parameters.modifiers.vehicle);
    model.rail = std::move(rail);
    model.wheels_m = vehicle::wheel_positions(parameters.vehicle);
    const double constant = contact_constant(parameters.contact, parameters.vehicle.wheel_radius_m);
    model.contact_compliance.fill(1.0 / contact_stiffness(constant, wheel_load_n(parameters)));
    model.contact_factor = parameters.modifiers.contact;
    return model;
}

namespace {

/// Inverse by Gauss–Jordan without pivoting: iω times this matrix is a passive mobility (its Hermitian part is not
/// negative), for which elimination in any order is stable.
void invert(WheelMatrix& m) {
    for (int k = 0; k < 4; ++k) {
        const Complex pivot = lanes::reciprocal(m[k][k]);
        m[k][k] = Complex(1.0);
        for (int j = 0; j < 4; ++j) m[k][j] = m[k][j] * pivot;
        for (int i = 0; i < 4; ++i) {
            if (i == k) continue;
            const Complex factor = m[i][k];
            m[i][k] = Complex{};
            for (int j = 0; j < 4; ++j) m[i][j] -= factor * m[k][j];
        }
    }
}

void add_contact_compliance(const CoupledModel& model, lanes::Real omega, WheelMatrix& matrix) {
    if (model.contact_factor.empty()) {
        for (int i = 0; i < 4; ++i) matrix[i][i].re += model.contact_compliance[i];
        return;
    }
    const Complex inverse = lanes::reciprocal(model.contact_factor.at(omega));
    for (int i = 0; i < 4; ++i) matrix[i][i] += inverse * model.contact_compliance[i];
}

}  // namespace

RailGroup rail_group(lanes::Real omega, CoupledWorkspace& workspace) {
    RailGroup group{.omega = omega};
    const track::RailReceptance& rail = workspace.rail->at(omega);
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 4; ++j) group.rail[i][j] = rail.at(i, j);
        group.trackbed[i] = rail.trackbed[static_cast<std::size_t>(i)];
    }
    return group;
}

const GroupSolution& solve_group(const CoupledModel& model, const RailGroup& rail, CoupledWorkspace& workspace) {
    GroupSolution& solution = workspace.solution;
    solution.omega = rail.omega;
    solution.car = vehicle::wheel_receptance(model.car, rail.omega, workspace.car);
    solution.rail = rail.rail;
    solution.trackbed = rail.trackbed;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) solution.forces[i][j] = solution.car.wheel(i, j) + solution.rail[i][j];
    add_contact_compliance(model, rail.omega, solution.forces);
    invert(solution.forces);
    return solution;
}

const GroupSolution& solve_group(const CoupledModel& model, lanes::Real omega, CoupledWorkspace& workspace) {
    return solve_group(model, rail_group(omega, workspace), workspace);
}

WheelVector contact_forces(const GroupSolution& solution, const WheelVector& irregularity) {
    WheelVector force;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j) force[i] += solution.forces[i][j] * irregularity[j];
    return force;
}

void responses(const GroupSolution& solution, const WheelVector& irregularity, Complex* result) {
    const WheelVector force = contact_forces(solution, irregularity);
    const lanes::Real to_acceleration = -solution.omega * solution.omega;
    for (const auto& receptance : solution.car.at) {
        Complex displacement;
        for (int j = 0; j < 4; ++j) displacement += receptance[j] * force[j];
        *result++ = displacement * to_acceleration;
    }
    for (int i = 0; i < 4; ++i) {  // the contact force pushes the rail down
        Complex displacement;
        for (int j = 0; j < 4; ++j) displacement -= solution.rail[i][j] * force[j];
        *result++ = displacement * to_acceleration;
    }
    for (int i = 0; i < 4; ++i) *result++ = force[i];
    Complex trackbed;
    for (int j = 0; j < 4; ++j) trackbed += solution.trackbed[j] * force[j];
    *result = trackbed;
}

}  // namespace railpem::pem
