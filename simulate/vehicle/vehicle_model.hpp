#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "simulate/numerics/radau_step.hpp"
#include "simulate/only_here_parameters.hpp"
#include "vehicle/vehicle_parameters.hpp"

namespace railpem::simulate {

/// Damper in series with a spring across u = direction·y: the force k_s·(u − h), τ·dh/dt = u − h, τ = c/k_s.
struct MaxwellElement {
    Eigen::VectorXd direction;
    double stiffness_n_per_m;
    double time_s;
};

/// Nonlinear force across u = direction·y, opposing: friction F(u̇) or a bump stop F(u).
struct NonlinearElement {
    enum class Law { friction, bump_stop };
    Eigen::VectorXd direction;
    Law law = Law::friction;
    double force_n = 0.0;        ///< friction: sliding force
    double static_excess = 0.0;  ///< friction: static over sliding force, minus 1 (Stribeck)
    double stribeck_velocity_m_per_s = 0.01;
    double stiffness_n_per_m = 0.0;  ///< bump stop
    double gap_m = 0.0;
};

struct ForceAndSlope {
    double force, slope;
};

/// Force of the element for u̇ (friction) or u (bump stop), N, and its derivative. Dry friction F·sgn(u̇) is
/// F·tanh(u̇/v0), v0 = friction_velocity_m_per_s: of 0.02 m/s rms it dissipates what the sharp law does within 0.3 %.
inline constexpr double friction_velocity_m_per_s = 5e-4;
ForceAndSlope force_of(const NonlinearElement& element, double value);

/// Half the vehicle on one rail, marched in deviations from its static equilibrium. Degrees of freedom, upwards
/// positive: body heave and pitch, bogie 1 heave and pitch, bogie 2 heave and pitch, wheels 1 to 4, then those of modes
/// and attached masses. Each is independent, so the mass matrix is diagonal.
struct VehicleModel {
    Eigen::VectorXd mass;
    Eigen::MatrixXd damping, stiffness;
    std::vector<MaxwellElement> maxwell;
    std::vector<NonlinearElement> nonlinear;
    std::array<Eigen::VectorXd, 4> wheel;   ///< rows: displacement of wheel j at contact and axle box
    std::vector<Eigen::VectorXd> channels;  ///< rows of channel_names()
};

VehicleModel vehicle_model(const vehicle::VehicleParameters& vehicle, const OnlyHereParameters& only_here);

/// State and the transforms of the current step.
struct VehicleState {
    Eigen::VectorXd displacement, velocity, acceleration;
    std::vector<double> maxwell_m;  ///< h of each Maxwell element
    Eigen::VectorXcd solution;      ///< displacement
};

/// The model at the step's complex frequency.
struct VehicleStep {
    Eigen::MatrixXcd receptance;
    std::vector<Complex> maxwell_weight;  ///< k_s·sτ/(1 + sτ)·1̂
    std::vector<Complex> maxwell_old, maxwell_new;
};

VehicleStep vehicle_step(const VehicleModel& model, const RadauStep& step);
VehicleState vehicle_at_rest(const VehicleModel& model);

/// Response to the state at the start of the step alone; `state.solution` is set.
void begin_step(const VehicleModel& model, const VehicleStep& numbers, const RadauStep& step, VehicleState& state);

/// New state from the complete solution.
void finish_step(const VehicleModel& model, const VehicleStep& numbers, const RadauStep& step, VehicleState& state);

}  // namespace railpem::simulate
