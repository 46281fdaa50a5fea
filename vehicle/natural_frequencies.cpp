#include "vehicle/natural_frequencies.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace railpem::vehicle {

namespace {

constexpr double kFullTurn = 2.0 * std::numbers::pi;
constexpr double kRounding = 1e-9;  ///< of an eigenvalue, relative: what is damped less is not damped

/// Mass, damping and stiffness of the car, and the rates of its Maxwell elements' inner ends.
struct Matrices {
    Eigen::MatrixXd mass, damping, stiffness;
    std::vector<Eigen::VectorXd> maxwell;  ///< elongation of each as a row over the degrees of freedom
    std::vector<double> series, rate;      ///< k_s in N/m, k_s/c in 1/s
};

Eigen::VectorXd row_of(const std::vector<Share>& shares, int degrees) {
    Eigen::VectorXd row = Eigen::VectorXd::Zero(degrees);
    for (const Share& share : shares) row(share.degree) += share.weight;
    return row;
}

void add_suspension(const SuspensionParameters& law, double friction, const Eigen::VectorXd& row, Matrices& all) {
    all.stiffness += law.stiffness_n_per_m * row * row.transpose();
    all.damping += friction * row * row.transpose();
    if (law.damping_n_s_per_m <= 0.0) return;
    if (!std::isfinite(law.damper_series_stiffness_n_per_m)) {
        all.damping += law.damping_n_s_per_m * row * row.transpose();
        return;
    }
    all.stiffness += law.damper_series_stiffness_n_per_m * row * row.transpose();
    all.maxwell.push_back(row);
    all.series.push_back(law.damper_series_stiffness_n_per_m);
    all.rate.push_back(law.damper_series_stiffness_n_per_m / law.damping_n_s_per_m);
}

Matrices matrices_of(const HalfVehicle& car, double ground) {
    const int n = car.degrees;
    Matrices all{Eigen::MatrixXd::Zero(n, n), Eigen::MatrixXd::Zero(n, n), Eigen::MatrixXd::Zero(n, n), {}, {}, {}};
    for (const Element& element : car.elements) {
        const Eigen::VectorXd row = row_of(element.shares, n);
        const double natural = kFullTurn * element.frequency_hz;
        if (element.law == Law::primary)
            add_suspension(car.primary, car.friction.primary[static_cast<std::size_t>(element.index)], row, all);
        else if (element.law == Law::secondary)
            add_suspension(car.secondary, car.friction.secondary[static_cast<std::size_t>(element.index)], row, all);
        else if (element.law != Law::attached && (element.law == Law::inertia || element.mass_moves))
            all.mass += element.mass_kg * row * row.transpose();
        if (element.law != Law::mode) continue;
        all.stiffness += element.mass_kg * natural * natural * row * row.transpose();
        all.damping += 2.0 * element.damping_ratio * natural * element.mass_kg * row * row.transpose();
    }
    for (int wheel = car.first_wheel(); wheel < n; ++wheel) all.stiffness(wheel, wheel) += ground;
    return all;
}

/// d/dt of displacements, velocities and inner ends of the Maxwell elements.
Eigen::MatrixXd first_order(const Matrices& all) {
    const long n = all.mass.rows(), inner = static_cast<long>(all.maxwell.size());
    const Eigen::LDLT<Eigen::MatrixXd> mass(all.mass);
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(2 * n + inner, 2 * n + inner);
    a.block(0, n, n, n).setIdentity();
    a.block(n, 0, n, n) = -mass.solve(all.stiffness);
    a.block(n, n, n, n) = -mass.solve(all.damping);
    for (long i = 0; i < inner; ++i) {
        const auto own = static_cast<std::size_t>(i);
        a.block(n, 2 * n + i, n, 1) = mass.solve(all.series[own] * all.maxwell[own]);
        a.block(2 * n + i, 0, 1, n) = all.rate[own] * all.maxwell[own].transpose();
        a(2 * n + i, 2 * n + i) = -all.rate[own];
    }
    return a;
}

/// Whose kinetic energy an element holds. Heave comes before pitch in the car's elements.
Motion motion_of(const HalfVehicle& car, const Element& element) {
    if (element.carrier == Carrier::wheel) return Motion::wheels;
    if (element.carrier == Carrier::none) return Motion::bending_or_hung;
    for (const Element& earlier : car.elements) {
        if (&earlier == &element) break;
        if (earlier.carrier == element.carrier && earlier.index == element.index)
            return element.carrier == Carrier::body ? Motion::body_pitch : Motion::bogie_pitch;
    }
    return element.carrier == Carrier::body ? Motion::body_bounce : Motion::bogie_bounce;
}

Motion strongest_motion(const HalfVehicle& car, const Eigen::VectorXcd& displacement) {
    std::map<Motion, double> energy;
    for (const Element& element : car.elements)
        if (element.law == Law::inertia || (element.law == Law::mode && element.mass_moves))
            energy[motion_of(car, element)] +=
                element.mass_kg *
                std::norm((row_of(element.shares, car.degrees).cast<std::complex<double>>().transpose() *
                           displacement.head(car.degrees))(0));
    return std::max_element(energy.begin(), energy.end(),
                            [](const auto& a, const auto& b) { return a.second < b.second; })
        ->first;
}

}  // namespace

std::string motion_name(Motion motion) {
    switch (motion) {
        case Motion::body_bounce:
            return "body bounce";
        case Motion::body_pitch:
            return "body pitch";
        case Motion::bogie_bounce:
            return "bogie bounce";
        case Motion::bogie_pitch:
            return "bogie pitch";
        case Motion::wheels:
            return "wheels on the track";
        case Motion::bending_or_hung:
            return "bending or hung mass";
    }
    return "";
}

std::vector<NaturalFrequency> natural_frequencies(const HalfVehicle& car, double ground_n_per_m) {
    const Eigen::EigenSolver<Eigen::MatrixXd> solver(first_order(matrices_of(car, ground_n_per_m)));
    std::vector<NaturalFrequency> all;
    for (long i = 0; i < solver.eigenvalues().size(); ++i) {
        const std::complex<double> value = solver.eigenvalues()(i);
        if (!(value.imag() > kRounding * std::abs(value))) continue;  // one of a pair, and none that creeps
        const double damping = -value.real() / std::abs(value);
        all.push_back({.frequency_hz = std::abs(value) / kFullTurn,
                       .damping_ratio = damping > kRounding ? damping : 0.0,
                       .motion = strongest_motion(car, solver.eigenvectors().col(i))});
    }
    std::sort(all.begin(), all.end(),
              [](const NaturalFrequency& a, const NaturalFrequency& b) { return a.frequency_hz < b.frequency_hz; });
    return all;
}

}  // namespace railpem::vehicle
