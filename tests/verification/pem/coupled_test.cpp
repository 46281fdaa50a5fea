// The coupled vehicle and track against conservation of energy, symmetry and limits in which one of the two is known in
// closed form. Everything that is compared with is written out here.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <complex>
#include <cstring>
#include <numbers>

#include "paper_case.hpp"
#include "pem/contact.hpp"
#include "pem/coupling/coupled_model.hpp"
#include "pem/coupling/solution.hpp"
#include "pem/coupling/solve_case.hpp"
#include "pem/rail/case_equilibrium.hpp"
#include "pem/response_names.hpp"
#include "spectra/irregularity_spectrum.hpp"
#include "track/rail/exact_rail.hpp"

namespace {

using namespace railpem;
using Complex = std::complex<double>;
using railpem::tests::paper_case;

constexpr double kTwoPi = 2.0 * std::numbers::pi;

std::vector<Complex> line(const pem::CaseParameters& parameters, double frequency,
                          const std::array<Complex, 4>& irregularity) {
    const pem::CoupledModel model = pem::coupled_model(parameters, parameters.running.speeds_m_per_s.front());
    pem::CoupledWorkspace workspace(model);
    pem::WheelVector r;
    for (std::size_t i = 0; i < 4; ++i) r[i] = lanes::Complex(irregularity[i]);
    std::vector<lanes::Complex> result(pem::response_names().size());
    pem::responses(pem::solve_group(model, lanes::broadcast(kTwoPi * frequency), workspace), r, result.data());
    std::vector<Complex> first;
    for (const lanes::Complex& value : result) first.push_back(value[0]);
    return first;
}

/// A rail so stiff and pads so hard that nothing gives: the wheels follow the irregularity through the contact spring
/// only. Reference: (1/K_h + V)⁻¹ with V from the ten equations of motion by hand (Eigen).
TEST(Limits, RigidTrackLeavesTheVehicle) {
    pem::CaseParameters parameters = paper_case(1);
    parameters.track.rail.second_moment_of_area_m4 = 1e3;
    parameters.track.pads.static_stiffness_n_per_m = 1e16;
    parameters.track.pads.force_polynomial_n.clear();
    const double f = 37.0, omega = kTwoPi * f;
    const std::array<Complex, 4> r{Complex(1.0, 0.0), Complex(0.3, 0.4), Complex(-0.2, 0.9), Complex(0.5, -0.5)};
    const std::vector<Complex> solved = line(parameters, f, r);

    const Complex kp(2.1e6, omega * 4.9e4), ks(2.5e6, omega * 2.0e5);
    Eigen::Matrix<Complex, 10, 10> d = Eigen::Matrix<Complex, 10, 10>::Zero();
    const auto spring = [&](const Eigen::Matrix<double, 10, 1>& g, Complex k) {
        d += k * (g * g.transpose()).cast<Complex>();
    };
    for (int b = 0; b < 2; ++b) {
        Eigen::Matrix<double, 10, 1> g = Eigen::Matrix<double, 10, 1>::Zero();
        g(0) = 1.0;
        g(1) = b == 0 ? 9.0 : -9.0;
        g(2 + 2 * b) = -1.0;
        spring(g, ks);
        for (int w = 0; w < 2; ++w) {
            g.setZero();
            g(2 + 2 * b) = 1.0;
            g(3 + 2 * b) = w == 0 ? 1.2 : -1.2;
            g(6 + 2 * b + w) = -1.0;
            spring(g, kp);
        }
    }
    const double masses[10] = {19250, 1.25e6, 1490, 1800, 1490, 1800, 675, 675, 675, 675};
    for (int i = 0; i < 10; ++i) d(i, i) -= omega * omega * masses[i];
    const Eigen::MatrixXcd receptance = d.inverse().rightCols(4);
    Eigen::Matrix4cd a = receptance.bottomRows(4);
    const double g = 3.86e-8 * std::pow(0.42, -0.115);
    a.diagonal().array() += g / (1.5 * std::cbrt(80e3));
    const Eigen::Vector4cd force = a.partialPivLu().solve(Eigen::Map<const Eigen::Vector4cd>(r.data()));
    const Eigen::VectorXcd acceleration = -omega * omega * (receptance * force);
    // what is left of the track's compliance, 1e-16·(pads that share) against 1/K_h = 7e-10
    const double tolerance = 1e-5;
    EXPECT_NEAR(std::abs(solved[0] / acceleration(0) - 1.0), 0.0, tolerance);
    EXPECT_NEAR(std::abs(solved[3] / acceleration(2) - 1.0), 0.0, tolerance);
    for (int w = 0; w < 4; ++w) EXPECT_NEAR(std::abs(solved[5 + w] / acceleration(6 + w) - 1.0), 0.0, tolerance);
}

/// Work of the irregularity through the contact forces = dissipation in every suspension damper + in every pad. What
/// travels away along the infinite rail is dissipated in pads farther out; 72 m either side leave nothing.
TEST(PowerBalance, PerLine) {
    pem::CaseParameters parameters = paper_case(3);
    const double speed = parameters.running.speeds_m_per_s.front();
    const pem::CoupledModel model = pem::coupled_model(parameters, speed);
    const track::StaticEquilibrium equilibrium = pem::case_equilibrium(parameters);
    for (const double f : {1.0, 9.0, 37.0, 57.6, 75.1, 150.0, 200.0}) {
        const double omega = kTwoPi * f;
        pem::CoupledWorkspace workspace(model);
        const pem::GroupSolution& solved = pem::solve_group(model, lanes::broadcast(omega), workspace);
        std::array<Complex, 4> r, force;
        for (std::size_t j = 0; j < 4; ++j)
            r[j] = std::polar(1.0, -omega * (model.wheels_m[0] - model.wheels_m[j]) / speed);
        double supplied = 0.0;
        for (std::size_t i = 0; i < 4; ++i) {
            force[i] = 0.0;
            for (std::size_t j = 0; j < 4; ++j) force[i] += solved.forces[i][j][0] * r[j];
            // mean of P·ṙ: ½ Re(P*·iωr) = ½ ω Im(P·r*)
            supplied += 0.5 * omega * std::imag(force[i] * std::conj(r[i]));
        }
        // Vehicle: dissipation per damper from its elongation.
        const vehicle::HalfVehicle& car = model.car;
        vehicle::Workspace dense(car);
        vehicle::assemble(car, lanes::broadcast(omega), dense);
        Eigen::MatrixXcd stiffness(car.degrees, car.degrees);
        for (int i = 0; i < car.degrees; ++i)
            for (int j = 0; j <= i; ++j) stiffness(i, j) = stiffness(j, i) = dense.stiffness(i, j)[0];
        Eigen::VectorXcd push = Eigen::VectorXcd::Zero(car.degrees);
        for (int w = 0; w < 4; ++w) push(car.first_wheel() + w) = force[static_cast<std::size_t>(w)];
        const Eigen::VectorXcd q = stiffness.partialPivLu().solve(push);
        double vehicle_loss = 0.0;
        for (const vehicle::Element& element : car.elements) {
            if (element.law != vehicle::Law::primary && element.law != vehicle::Law::secondary) continue;
            Complex elongation = 0.0;
            for (const vehicle::Share& share : element.shares) elongation += share.weight * q(share.degree);
            const double damping = element.law == vehicle::Law::primary ? 4.9e4 : 2.0e5;
            vehicle_loss += 0.5 * omega * omega * damping * std::norm(elongation);
        }
        // Track: receptances from the wheels to every pad, each pad its own point, on a rail long enough that the rest
        // is nothing.
        double track_loss = 0.0;
        const double low = -72.0, high = 72.0;
        for (double x = std::ceil(low / 0.6) * 0.6; x <= high; x += 0.6) {
            std::vector<double> points(model.wheels_m);
            bool on_wheel = false;
            std::size_t wheel = 0;
            for (std::size_t w = 0; w < 4; ++w)
                if (std::abs(points[w] - x) < 1e-6) {
                    on_wheel = true;
                    wheel = w;
                }
            if (!on_wheel) {
                points.push_back(x);
                wheel = 4;
            }
            const track::ExactRail rail = track::exact_rail(parameters.track, points, equilibrium);
            track::ExactRailWorkspace work(rail);
            const track::RailReceptance& receptance = track::rail_receptance(rail, lanes::broadcast(omega), work);
            Complex displacement = 0.0;
            for (int j = 0; j < 4; ++j)
                displacement -= receptance.at(static_cast<int>(wheel), j)[0] * force[static_cast<std::size_t>(j)];
            track_loss += 0.5 * omega * omega * parameters.track.pads.damping_n_s_per_m * std::norm(displacement);
        }
        EXPECT_NEAR((vehicle_loss + track_loss) / supplied, 1.0, 1e-10) << f << " Hz";
    }
}

TEST(Symmetry, ContactForcesAreReciprocalAtRest) {
    const pem::CoupledModel model = pem::coupled_model(paper_case(3), 22.0);
    pem::CoupledWorkspace workspace(model);
    const pem::GroupSolution& solved = pem::solve_group(model, lanes::broadcast(400.0), workspace);
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_NEAR(std::abs(solved.forces[i][j][0] - solved.forces[j][i][0]) / std::abs(solved.forces[i][i][0]),
                        0.0, 1e-12);
}

/// The symmetric vehicle run backwards: wheel 1 becomes wheel 4, the front of the body its rear.
TEST(Symmetry, RunsBackwardsAlike) {
    const pem::CaseParameters parameters = paper_case(3);
    const std::array<Complex, 4> ahead{1.0, Complex(0.2, 0.6), Complex(-0.4, 0.1), Complex(0.3, -0.7)};
    const std::array<Complex, 4> reversed{ahead[3], ahead[2], ahead[1], ahead[0]};
    const std::vector<Complex> a = line(parameters, 63.0, ahead), b = line(parameters, 63.0, reversed);
    EXPECT_NEAR(std::abs(a[pem::response_index("wheel_1")] - b[pem::response_index("wheel_4")]) / std::abs(a[5]), 0.0,
                1e-11);
    EXPECT_NEAR(std::abs(a[pem::response_index("rail_2")] - b[pem::response_index("rail_3")]) / std::abs(a[9]), 0.0,
                1e-11);
    EXPECT_NEAR(std::abs(a[pem::response_index("body_front")] - b[pem::response_index("body_rear")]) / std::abs(a[1]),
                0.0, 1e-11);
}

/// Wheels too far apart to feel each other through rail or frame: no comb, the response of one wheel is smooth in
/// frequency.
TEST(Limits, OneWheelHasNoComb) {
    pem::CaseParameters parameters = paper_case(1);
    parameters.vehicle.wheelbase_m = 48.0;
    parameters.vehicle.bogie_distance_m = 300.0;
    parameters.vehicle.primary = {.stiffness_n_per_m = 1.0, .damping_n_s_per_m = 0.0};
    parameters.frequency = {.from_hz = 40.0, .to_hz = 100.0, .step_hz = 0.1};
    const auto teeth = [](const pem::CaseParameters& p) {
        const pem::Solution solution = pem::solve_case(p, 22.2222);
        const std::vector<double> psd = pem::response_psd(solution, pem::response_index("wheel_1"));
        int peaks = 0;
        for (std::size_t i = 1; i + 1 < psd.size(); ++i) peaks += psd[i] > psd[i - 1] && psd[i] > psd[i + 1];
        return peaks;
    };
    EXPECT_EQ(teeth(parameters), 1);
    EXPECT_GE(teeth(paper_case(1)), 5);  // v/2.4 m = 9.26 Hz over 60 Hz: six or seven teeth
}

/// A quarter car on a rough, rigid road: body and bogie locked together and to nothing, |H|² in closed form.
TEST(Limits, WheelOnRigidRoad) {
    pem::CaseParameters parameters = paper_case(1);
    parameters.track.rail.second_moment_of_area_m4 = 1e3;
    parameters.track.pads.static_stiffness_n_per_m = 1e16;
    parameters.track.pads.force_polynomial_n.clear();
    parameters.vehicle.primary = {.stiffness_n_per_m = 1e-3, .damping_n_s_per_m = 0.0};
    const double f = 90.0, omega = kTwoPi * f;
    const double kh = pem::contact_stiffness(pem::contact_constant(parameters.contact, 0.42), 80e3);
    const double expected = -omega * omega * kh / (kh - 675.0 * omega * omega);
    const std::vector<Complex> solved = line(parameters, f, {1.0, 0.0, 0.0, 0.0});
    EXPECT_NEAR(std::abs(solved[pem::response_index("wheel_1")] / expected - 1.0), 0.0, 1e-5);
    EXPECT_NEAR(std::abs(solved[pem::response_index("wheel_2")]) / std::abs(expected), 0.0, 1e-5);
}

/// The bits do not depend on the number of threads.
TEST(Threads, SameBits) {
    const pem::Solution one = pem::solve_case(paper_case(3), 22.2222, {.threads = 1});
    const pem::Solution two = pem::solve_case(paper_case(3), 22.2222, {.threads = 2});
    ASSERT_EQ(one.pseudo_response.size(), two.pseudo_response.size());
    EXPECT_EQ(std::memcmp(one.pseudo_response.data(), two.pseudo_response.data(),
                          one.pseudo_response.size() * sizeof(Complex)),
              0);
}

/// speed → 0: rolling wheels see the mean of the receptances over a bay, and the motion itself stops mattering.
TEST(Moving, SlowMotionIsTheMeanOverABay) {
    pem::CaseParameters parameters = paper_case(1);
    Eigen::Matrix4cd mean = Eigen::Matrix4cd::Zero();
    for (int k = 0; k < 24; ++k) {
        parameters.track.wheel_offset_m = k * 0.6 / 24;
        const pem::CoupledModel rest = pem::coupled_model(parameters, 1.0);
        pem::CoupledWorkspace workspace(rest);
        const pem::GroupSolution& solved = pem::solve_group(rest, lanes::broadcast(360.0), workspace);
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j < 4; ++j)
                mean(i, j) += solved.rail[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)][0] / 24.0;
    }
    parameters.track.wheel_offset_m = 0.0;
    parameters.solver.moving = true;
    const pem::CoupledModel slow = pem::coupled_model(parameters, 1e-6);
    pem::CoupledWorkspace workspace(slow);
    const pem::GroupSolution& solved = pem::solve_group(slow, lanes::broadcast(360.0), workspace);
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)  // three positions leave the third harmonic of a bay, 5e-5 of the mean
            EXPECT_NEAR(
                std::abs(solved.rail[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)][0] - mean(i, j)) /
                    std::abs(mean(0, 0)),
                0.0, 1e-4);
}

}  // namespace
