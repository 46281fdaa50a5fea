#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "simulate/track/track_window.hpp"
#include "simulate/vehicle/contact_law.hpp"
#include "simulate/vehicle/vehicle_model.hpp"

namespace railpem::simulate {

/// Where vehicle and track meet, and the nonlinear elements within the vehicle: all unknowns of a step that are not
/// linear.
///
/// For element e (contacts 1 to 4, then the vehicle's own) and stage i, y is the approach (contact), the relative
/// velocity (friction) or the relative displacement (bump stop), and p(y) its force. With everything else linear within
/// the step
///   y = y_free + B·p(y),   B_(e,i)(f,k) = ±2·Re(t_i·(1 or s)·r_e·D⁻¹·r_fᵀ·τ_k) − rail and element compliance
///   (contacts),
/// which Newton's method solves for y (Jacobian 1 − B·diag p′). Unknowns in order 2e + i.
struct Junction {
    static constexpr int most_unknowns = 40;
    using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most_unknowns, 1>;
    using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most_unknowns, most_unknowns>;

    ContactLaw contact;
    std::vector<NonlinearElement> elements;
    Eigen::MatrixXcd columns;           ///< D⁻¹·r_f: response of the vehicle to the force of element f
    std::vector<Eigen::VectorXd> rows;  ///< r_e with the sign of y
    Matrix vehicle_coupling;            ///< B without rail
    Matrix coupling;                    ///< B of the current step
    Vector free;                        ///< y_free
    Vector value;                       ///< y; kept as the first guess of the next step
    Vector force;                       ///< p(y)

    Eigen::Index unknowns() const { return value.size(); }
};

Junction make_junction(const VehicleModel& model, const VehicleStep& numbers, const RadauStep& step,
                       const ContactLaw& contact);

/// The vehicle's part of y_free from its solution without junction forces; contacts also get the static load P0 taken
/// off.
void set_free_vehicle(Junction& junction, const RadauStep& step, const VehicleState& state);

/// Newton with step halving from the present value. Returns the number of iterations.
int solve_junction(Junction& junction);

/// Adds the response to the junction forces to the vehicle's solution.
void apply_to_vehicle(const Junction& junction, const RadauStep& step, VehicleState& state);

}  // namespace railpem::simulate
