#pragma once
// Vehicle, contact and rail coupled at the wheels.

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "lanes/complex_lanes.hpp"
#include "pem/case_parameters.hpp"
#include "pem/rail_model.hpp"
#include "vehicle/half_vehicle.hpp"

namespace railpem::pem {

/// A case prepared for all frequencies: what does not depend on the frequency is computed once.
struct CoupledModel {
    vehicle::HalfVehicle car;
    std::unique_ptr<RailModel> rail;
    std::vector<double> wheels_m;             ///< positions of the wheels, front first
    std::array<double, 4> contact_compliance{};  ///< 1/K_h per wheel, m/N
    std::vector<std::string> warnings;
};

CoupledModel coupled_model(const CaseParameters& parameters);

using WheelVector = std::array<lanes::Complex, 4>;
using WheelMatrix = std::array<WheelVector, 4>;  ///< [row][column]

/// One group of lines solved: contact forces per unit irregularity, and the receptances they act through.
struct GroupSolution {
    lanes::Real omega{};
    WheelMatrix forces;  ///< [i][j]: contact force at wheel i per unit irregularity under wheel j, N/m
    vehicle::WheelReceptance car;
    const track::RailReceptance* rail = nullptr;
};

/// What one thread needs.
struct CoupledWorkspace {
    explicit CoupledWorkspace(const CoupledModel& model) : car(model.car), rail(model.rail->evaluator()) {}
    vehicle::Workspace car;
    std::unique_ptr<RailEvaluator> rail;
    GroupSolution solution;
};

/// P = (1/K_h + V + R)⁻¹·r: V and R the receptances of vehicle and rail at the wheels, r the irregularity (upwards).
/// `moving_change`: R(v) − R(0) of the convected rail, or null.
const GroupSolution& solve_group(const CoupledModel& model, lanes::Real omega, const WheelMatrix* moving_change, CoupledWorkspace& workspace);

/// All responses (order of response_names()) to irregularities r under the four wheels, in (m/s²) and N per unit of r.
void responses(const GroupSolution& solution, const WheelVector& irregularity, lanes::Complex* result);

}  // namespace railpem::pem
