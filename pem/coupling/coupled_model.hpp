#pragma once
// Vehicle, contact and rail coupled at the wheels.

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "lanes/complex_lanes.hpp"
#include "pem/case_parameters.hpp"
#include "pem/rail/rail_model.hpp"
#include "pem/wheel_matrix.hpp"
#include "vehicle/half_vehicle.hpp"

namespace railpem::pem {

/// A case prepared for all frequencies: what does not depend on the frequency is computed once.
struct CoupledModel {
    vehicle::HalfVehicle car;
    std::shared_ptr<const RailModel> rail;
    std::vector<double> wheels_m;                ///< positions of the wheels, front first
    std::array<double, 4> contact_compliance{};  ///< 1/K_h per wheel without its factor, m/N
    lanes::FactorCurve contact_factor;           ///< on K_h, Modifiers::contact
    std::vector<std::string> warnings;
};

/// `speed_m_per_s` matters only for a case with solver.moving.
CoupledModel coupled_model(const CaseParameters& parameters, double speed_m_per_s);

/// The same on the `rail` of a case whose track, speed and wheels are the same, and its load where that stiffens the
/// pads. Without warnings.
CoupledModel coupled_model(const CaseParameters& parameters, std::shared_ptr<const RailModel> rail);

/// One group of lines solved: contact forces per unit irregularity, and the receptances they act through.
struct GroupSolution {
    lanes::Real omega{};
    WheelMatrix forces;  ///< [i][j]: contact force at wheel i per unit irregularity under wheel j, N/m
    vehicle::WheelReceptance car;
    WheelMatrix rail;      ///< receptances of the rail between the wheels, in motion if the case says so
    WheelVector trackbed;  ///< sum of all pad forces per unit force at each wheel
};

/// The rail's part of one group of lines. It does not depend on vehicle, contact or excitation.
struct RailGroup {
    lanes::Real omega{};
    WheelMatrix rail;      ///< receptances between the wheels, in motion if the case says so
    WheelVector trackbed;  ///< sum of all pad forces per unit force at each wheel
};

/// What one thread needs.
struct CoupledWorkspace {
    explicit CoupledWorkspace(const CoupledModel& model) : car(model.car), rail(model.rail->evaluator()) {}
    vehicle::Workspace car;
    std::unique_ptr<RailEvaluator> rail;
    GroupSolution solution;
};

RailGroup rail_group(lanes::Real omega, CoupledWorkspace& workspace);

/// Vehicle and contact on a rail that is known.
const GroupSolution& solve_group(const CoupledModel& model, const RailGroup& rail, CoupledWorkspace& workspace);

/// P = (1/K_h + V + R)⁻¹·r: V and R the receptances of vehicle and rail at the wheels, r the irregularity (upwards).
const GroupSolution& solve_group(const CoupledModel& model, lanes::Real omega, CoupledWorkspace& workspace);

/// Contact forces P for irregularities r under the four wheels.
WheelVector contact_forces(const GroupSolution& solution, const WheelVector& irregularity);

/// All responses (order of response_names()) to irregularities r under the four wheels, in (m/s²) and N per unit of r.
void responses(const GroupSolution& solution, const WheelVector& irregularity, lanes::Complex* result);

}  // namespace railpem::pem
