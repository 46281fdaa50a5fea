#include "simulate/vehicle/junction.hpp"

#include <Eigen/LU>
#include <cassert>

namespace railpem::simulate {

namespace {

bool measures_velocity(const Junction& junction, std::size_t e) {
    return e >= 4 && junction.elements[e - 4].law == NonlinearElement::Law::friction;
}

ForceAndSlope law_of(const Junction& junction, Eigen::Index unknown) {
    const auto e = static_cast<std::size_t>(unknown / 2);
    if (e < 4) return contact_force(junction.contact, junction.value[unknown]);
    return force_of(junction.elements[e - 4], junction.value[unknown]);
}

/// y − y_free − B·p; also leaves forces in the junction and returns the slopes.
Junction::Vector residual(Junction& junction, Junction::Vector& slope) {
    for (Eigen::Index i = 0; i < junction.unknowns(); ++i) {
        const ForceAndSlope law = law_of(junction, i);
        junction.force[i] = law.force;
        slope[i] = law.slope;
    }
    return junction.value - junction.free - junction.coupling * junction.force;
}

}  // namespace

Junction make_junction(const VehicleModel& model, const VehicleStep& numbers, const RadauStep& step,
                       const ContactLaw& contact) {
    Junction junction;
    junction.contact = contact;
    junction.elements = model.nonlinear;
    // A contact force pushes the wheel up and its approach falls as the wheel rises; the other elements oppose their y.
    for (const Eigen::VectorXd& row : model.wheel) junction.rows.emplace_back(-row);
    for (const NonlinearElement& element : model.nonlinear) junction.rows.push_back(element.direction);
    const auto count = static_cast<Eigen::Index>(junction.rows.size());
    assert(2 * count <= Junction::most_unknowns);
    junction.columns.resize(model.mass.size(), count);
    for (Eigen::Index e = 0; e < count; ++e)
        junction.columns.col(e) = numbers.receptance * (-junction.rows[static_cast<std::size_t>(e)]);
    junction.vehicle_coupling.resize(2 * count, 2 * count);
    for (Eigen::Index e = 0; e < count; ++e)
        for (Eigen::Index f = 0; f < count; ++f) {
            Complex c =
                junction.rows[static_cast<std::size_t>(e)].cast<Complex>().cwiseProduct(junction.columns.col(f)).sum();
            if (measures_velocity(junction, static_cast<std::size_t>(e))) c *= step.s;
            for (Eigen::Index k = 0; k < 2; ++k) {
                const Complex driven = c * (k == 0 ? step.tau1 : step.tau2);
                junction.vehicle_coupling(2 * e, 2 * f + k) = step.at_first(driven);
                junction.vehicle_coupling(2 * e + 1, 2 * f + k) = RadauStep::at_end(driven);
            }
        }
    junction.coupling = junction.vehicle_coupling;
    junction.free = Junction::Vector::Zero(2 * count);
    junction.value = Junction::Vector::Zero(2 * count);
    junction.value.head<8>().setConstant(static_approach(contact));
    junction.force = Junction::Vector::Zero(2 * count);
    junction.force.head<8>().setConstant(contact.static_load_n);
    return junction;
}

void set_free_vehicle(Junction& junction, const RadauStep& step, const VehicleState& state) {
    for (std::size_t e = 0; e < junction.rows.size(); ++e) {
        Complex y = junction.rows[e].dot(state.solution);
        if (measures_velocity(junction, e)) y = step.derivative(y, junction.rows[e].dot(state.displacement));
        junction.free[2 * static_cast<Eigen::Index>(e)] = step.at_first(y);
        junction.free[2 * static_cast<Eigen::Index>(e) + 1] = RadauStep::at_end(y);
    }
    // The vehicle moves about its equilibrium under P0: only P − P0 acts.
    junction.free -=
        junction.vehicle_coupling.leftCols<8>() * Junction::Vector::Constant(8, junction.contact.static_load_n);
}

int solve_junction(Junction& junction) {
    constexpr int most = 60;
    constexpr double tolerance = 1e-13;  // m and m/s: 1e-13 m of approach are 1e-4 N of contact force
    const Eigen::Index n = junction.unknowns();
    Junction::Vector slope(n);
    Junction::Vector g = residual(junction, slope);
    for (int iteration = 0; iteration < most; ++iteration) {
        const double size = g.lpNorm<Eigen::Infinity>();
        if (size < tolerance) return iteration;
        Junction::Matrix jacobian = -junction.coupling * slope.asDiagonal();
        jacobian.diagonal().array() += 1.0;
        const Junction::Vector change = jacobian.partialPivLu().solve(g);
        const Junction::Vector before = junction.value;
        double fraction = 1.0;
        for (int halving = 0; halving < 12; ++halving, fraction *= 0.5) {
            junction.value = before - fraction * change;
            g = residual(junction, slope);
            if (g.lpNorm<Eigen::Infinity>() < size) break;
        }
        if (change.lpNorm<Eigen::Infinity>() < 1e-15) return iteration;
    }
    return most;
}

void apply_to_vehicle(const Junction& junction, const RadauStep& step, VehicleState& state) {
    for (Eigen::Index e = 0; e < junction.columns.cols(); ++e) {
        const double taken = e < 4 ? junction.contact.static_load_n : 0.0;
        state.solution +=
            step.transform(junction.force[2 * e] - taken, junction.force[2 * e + 1] - taken) * junction.columns.col(e);
    }
}

}  // namespace railpem::simulate
