#include "pem/coupled_model.hpp"

#include "pem/contact.hpp"
#include "pem/solution.hpp"

namespace railpem::pem {

using lanes::Complex;

CoupledModel coupled_model(const CaseParameters& parameters) {
    CoupledModel model;
    model.car = vehicle::half_vehicle(parameters.vehicle);
    model.wheels_m = vehicle::wheel_positions(parameters.vehicle);
    const track::StaticEquilibrium equilibrium = case_equilibrium(parameters);
    model.rail = rail_model(parameters, model.wheels_m, equilibrium);
    if (parameters.track.pads.preload_strength > 0.0) model.warnings = equilibrium.warnings;
    const double constant = contact_constant(parameters.contact, parameters.vehicle.wheel_radius_m);
    model.contact_compliance.fill(1.0 / contact_stiffness(constant, wheel_load_n(parameters)));
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

}  // namespace

const GroupSolution& solve_group(const CoupledModel& model, lanes::Real omega, const WheelMatrix* moving_change, CoupledWorkspace& workspace) {
    GroupSolution& solution = workspace.solution;
    solution.omega = omega;
    solution.car = vehicle::wheel_receptance(model.car, omega, workspace.car);
    solution.rail = &workspace.rail->at(omega);
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) {
            solution.forces[i][j] = solution.car.wheel(i, j) + solution.rail->at(i, j);
            if (moving_change) solution.forces[i][j] += (*moving_change)[i][j];
        }
    for (int i = 0; i < 4; ++i) solution.forces[i][i].re += model.contact_compliance[i];
    invert(solution.forces);
    return solution;
}

void responses(const GroupSolution& solution, const WheelVector& irregularity, Complex* result) {
    WheelVector force;
    for (int i = 0; i < 4; ++i) {
        force[i] = Complex{};
        for (int j = 0; j < 4; ++j) force[i] += solution.forces[i][j] * irregularity[j];
    }
    const lanes::Real to_acceleration = -solution.omega * solution.omega;
    for (const auto& receptance : solution.car.at) {
        Complex displacement;
        for (int j = 0; j < 4; ++j) displacement += receptance[j] * force[j];
        *result++ = displacement * to_acceleration;
    }
    for (int i = 0; i < 4; ++i) {  // rail under the wheel: contact minus irregularity and contact compression, = −R·P at v = 0
        Complex displacement;
        for (int j = 0; j < 4; ++j) displacement -= solution.rail->at(i, j) * force[j];
        *result++ = displacement * to_acceleration;
    }
    for (int i = 0; i < 4; ++i) *result++ = force[i];
    Complex trackbed;
    for (int j = 0; j < 4; ++j) trackbed += solution.rail->trackbed[static_cast<std::size_t>(j)] * force[j];
    *result = trackbed;
}

}  // namespace railpem::pem
