// The half vehicle against equations of motion written out by hand (mass, damping, stiffness matrices of the ten
// degrees of freedom in the paper's order) and solved with Eigen; modes and extra elements against their limits and
// closed forms.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <complex>
#include <numbers>

#include "parameters/parameter_error.hpp"
#include "vehicle/half_vehicle.hpp"

namespace {

using namespace railpem;
using vehicle::Place;
using Complex = std::complex<double>;
constexpr Complex kI{0.0, 1.0};

vehicle::VehicleParameters type_a() {
    vehicle::VehicleParameters car;
    car.body_mass_kg = 38500;
    car.body_pitch_inertia_kg_m2 = 2.5e6;
    car.bogie_mass_kg = 2980;
    car.bogie_pitch_inertia_kg_m2 = 3.6e3;
    car.wheelset_mass_kg = 1350;
    car.bogie_distance_m = 18.0;
    car.wheelbase_m = 2.4;
    car.primary = {.stiffness_n_per_m = 2.1e6, .damping_n_s_per_m = 4.9e4};
    car.secondary = {.stiffness_n_per_m = 2.5e6, .damping_n_s_per_m = 2.0e5};
    return car;
}

/// Receptances at the wheels from the equations of motion, degrees of freedom: z_c, θ_c, z_1, θ_1, z_2, θ_2, wheels.
Eigen::MatrixXcd by_hand(const vehicle::VehicleParameters& car, double omega) {
    const double l = car.bogie_distance_m / 2.0, a = car.wheelbase_m / 2.0;
    const auto stage = [&](const vehicle::SuspensionParameters& s) {
        Eigen::Matrix<double, 10, 10> unit = Eigen::Matrix<double, 10, 10>::Zero();
        if (&s == &car.secondary) {
            unit(0, 0) = 2;
            unit(1, 1) = 2 * l * l;
            unit(2, 2) = unit(4, 4) = 1;
            unit(0, 2) = unit(2, 0) = unit(0, 4) = unit(4, 0) = -1;
            unit(1, 2) = unit(2, 1) = -l;
            unit(1, 4) = unit(4, 1) = l;
        } else {
            for (const int b : {0, 1}) {
                const int z = 2 + 2 * b, w = 6 + 2 * b;
                unit(z, z) = 2;
                unit(z + 1, z + 1) = 2 * a * a;
                unit(w, w) = unit(w + 1, w + 1) = 1;
                unit(z, w) = unit(w, z) = unit(z, w + 1) = unit(w + 1, z) = -1;
                unit(z + 1, w) = unit(w, z + 1) = -a;
                unit(z + 1, w + 1) = unit(w + 1, z + 1) = a;
            }
        }
        return Eigen::Matrix<Complex, 10, 10>(unit * Complex(s.stiffness_n_per_m, omega * s.damping_n_s_per_m));
    };
    Eigen::Matrix<Complex, 10, 10> d = stage(car.secondary) + stage(car.primary);
    const double halves[10] = {
        car.body_mass_kg,     car.body_pitch_inertia_kg_m2,  car.bogie_mass_kg,    car.bogie_pitch_inertia_kg_m2,
        car.bogie_mass_kg,    car.bogie_pitch_inertia_kg_m2, car.wheelset_mass_kg, car.wheelset_mass_kg,
        car.wheelset_mass_kg, car.wheelset_mass_kg};
    for (int i = 0; i < 10; ++i) d(i, i) -= omega * omega * halves[i] / 2.0;
    return d.inverse().rightCols(4);
}

vehicle::WheelReceptance solve(const vehicle::VehicleParameters& car, double omega) {
    const vehicle::HalfVehicle half = vehicle::half_vehicle(car);
    vehicle::Workspace workspace(half);
    return vehicle::wheel_receptance(half, lanes::broadcast(omega), workspace);
}

Complex at(const vehicle::WheelReceptance& r, Place place, int wheel) {
    return r.at[static_cast<std::size_t>(place)][static_cast<std::size_t>(wheel)][0];
}

TEST(HalfVehicle, TenDegreesOfFreedomByHand) {
    for (const double f : {0.3, 1.0, 7.0, 40.0, 200.0, 2000.0}) {
        const double omega = 2.0 * std::numbers::pi * f;
        const Eigen::MatrixXcd hand = by_hand(type_a(), omega);
        const vehicle::WheelReceptance solved = solve(type_a(), omega);
        const double scale = hand.cwiseAbs().maxCoeff();
        for (int w = 0; w < 4; ++w) {
            // Rounding of the elimination: condition number of D (about 1e5 at 0.3 Hz) times 1e-16.
            const double tolerance = 1e-11 * scale;
            EXPECT_NEAR(std::abs(at(solved, Place::body, w) - hand(0, w)), 0.0, tolerance) << f;
            EXPECT_NEAR(std::abs(at(solved, Place::body_front, w) - (hand(0, w) + 9.0 * hand(1, w))), 0.0, tolerance)
                << f;
            EXPECT_NEAR(std::abs(at(solved, Place::body_rear, w) - (hand(0, w) - 9.0 * hand(1, w))), 0.0, tolerance)
                << f;
            EXPECT_NEAR(std::abs(at(solved, Place::bogie_1, w) - hand(2, w)), 0.0, tolerance) << f;
            EXPECT_NEAR(std::abs(at(solved, Place::bogie_2, w) - hand(4, w)), 0.0, tolerance) << f;
            for (int i = 0; i < 4; ++i)
                EXPECT_NEAR(std::abs(solved.wheel(i, w)[0] - hand(6 + i, w)), 0.0, tolerance) << f;
        }
    }
}

/// All four wheels pushed with F: the free half car as a whole accelerates with 4F/m as ω → 0.
TEST(HalfVehicle, RigidBodyLimit) {
    const double omega = 2.0 * std::numbers::pi * 1e-3;
    const vehicle::WheelReceptance r = solve(type_a(), omega);
    Complex sum = 0.0;
    for (int w = 0; w < 4; ++w) sum += at(r, Place::body, w);
    const double half_mass = (38500.0 + 2 * 2980.0 + 4 * 1350.0) / 2.0;
    // next term (ω/ω_body)², ω_body = 2π·1 Hz
    EXPECT_NEAR((sum * (-omega * omega)).real() * half_mass / 4.0, 1.0, 1e-5);
}

TEST(HalfVehicle, RunsBackwardsAlike) {
    const vehicle::WheelReceptance r = solve(type_a(), 60.0);
    EXPECT_NEAR(std::abs(at(r, Place::wheel_1, 0) / at(r, Place::wheel_4, 3) - 1.0), 0.0, 1e-12);
    EXPECT_NEAR(std::abs(at(r, Place::body_front, 1) / at(r, Place::body_rear, 2) - 1.0), 0.0, 1e-12);
}

TEST(HalfVehicle, PayloadIsBodyMassAndInertiaInProportion) {
    vehicle::VehicleParameters loaded = type_a(), heavier = type_a();
    loaded.payload_kg = 7700.0;
    heavier.body_mass_kg *= 1.2;
    heavier.body_pitch_inertia_kg_m2 *= 1.2;
    const vehicle::WheelReceptance a = solve(loaded, 8.0), b = solve(heavier, 8.0);
    EXPECT_NEAR(std::abs(at(a, Place::body_front, 0) / at(b, Place::body_front, 0) - 1.0), 0.0, 1e-12);
}

/// The Maxwell element is the plain dashpot when slow and its series spring when fast (Bruni et al. 2011).
TEST(Suspension, MaxwellLimits) {
    vehicle::SuspensionParameters law{
        .stiffness_n_per_m = 2e6, .damping_n_s_per_m = 5e4, .damper_series_stiffness_n_per_m = 4e6};
    const double corner = 4e6 / 5e4;
    const Complex slow = vehicle::suspension_stiffness(law, 0.0, lanes::broadcast(1e-4 * corner))[0];
    EXPECT_NEAR(slow.imag() / (1e-4 * corner * 5e4), 1.0, 1e-7);  // next term (ω/corner)²
    const Complex fast = vehicle::suspension_stiffness(law, 0.0, lanes::broadcast(1e4 * corner))[0];
    EXPECT_NEAR(fast.real(), 6e6, 6e6 * 1e-7);
    law.damper_series_stiffness_n_per_m = 1e30;
    const Complex rigid = vehicle::suspension_stiffness(law, 0.0, lanes::broadcast(100.0))[0];
    EXPECT_NEAR(std::abs(rigid - (2e6 + kI * 5e6)), 0.0, 1e-6);
}

/// A free body with a bending mode, hardly suspended: pushed at its mode's frequency the mode answers with
/// 1/(2iζ·m·ω²).
TEST(BodyBending, FreeFreeResonance) {
    vehicle::VehicleParameters car = type_a();
    car.secondary = {.stiffness_n_per_m = 1.0, .damping_n_s_per_m = 0.0};
    car.body_bending.push_back(
        {.frequency_hz = 9.0, .damping_ratio = 0.02, .modal_mass_kg = 9000.0, .shape_at_pivots = -0.3});
    const vehicle::HalfVehicle half = vehicle::half_vehicle(car);
    EXPECT_EQ(half.degrees, 11);
    vehicle::Workspace workspace(half);
    const double omega = 2.0 * std::numbers::pi * 9.0;
    vehicle::assemble(half, lanes::broadcast(omega), workspace);
    workspace.stiffness.factorise();
    std::vector<lanes::Complex> q(11);
    q[0] = lanes::Complex(1.0);  // the mode is eliminated first
    workspace.stiffness.solve(q.data());
    const Complex expected = 1.0 / (2.0 * kI * 0.02 * 4500.0 * omega * omega);
    EXPECT_NEAR(std::abs(q[0][0] / expected - 1.0), 0.0, 1e-5);  // suspension of 1 N/m against 4500·(2π9)² = 1.4e7 N/m
}

/// The wheelset's bending mode: a free wheelset (no primary) is −1/(ω²M) + 1/(m(ω_n² − ω² + 2iζω_nω)), halves of both
/// masses.
TEST(WheelsetBending, FreeWheelset) {
    vehicle::VehicleParameters car = type_a();
    car.primary = {.stiffness_n_per_m = 1e-3, .damping_n_s_per_m = 0.0};
    car.wheelset_bending.push_back({.frequency_hz = 80.0, .damping_ratio = 0.01, .modal_mass_kg = 600.0});
    for (const double f : {20.0, 79.0, 80.0, 150.0}) {
        const double omega = 2.0 * std::numbers::pi * f, natural = 2.0 * std::numbers::pi * 80.0;
        const Complex expected =
            -1.0 / (omega * omega * 675.0) +
            1.0 / (300.0 * (natural * natural - omega * omega + 2.0 * kI * 0.01 * natural * omega));
        EXPECT_NEAR(std::abs(solve(car, omega).wheel(1, 1)[0] / expected - 1.0), 0.0, 1e-8) << f;
    }
}

/// A hung mass makes the frame heavier well below its frequency and lets go of it well above.
TEST(BogieMountedMass, HeavyBelowGoneAbove) {
    vehicle::VehicleParameters hung = type_a(), heavier = type_a();
    hung.bogie_mounted_masses.push_back({.mass_kg = 500.0, .frequency_hz = 30.0, .damping_ratio = 0.05});
    heavier.bogie_mass_kg += 500.0;
    const double low = 2.0 * std::numbers::pi * 0.3, high = 2.0 * std::numbers::pi * 3000.0;
    // (0.3/30)²
    EXPECT_NEAR(std::abs(at(solve(hung, low), Place::bogie_1, 0) / at(solve(heavier, low), Place::bogie_1, 0) - 1.0),
                0.0, 1e-4);
    // dashpot of the mounting
    EXPECT_NEAR(std::abs(at(solve(hung, high), Place::bogie_1, 0) / at(solve(type_a(), high), Place::bogie_1, 0) - 1.0),
                0.0, 1e-2);
}

TEST(VehicleParameters, RefusesWhatCannotBe) {
    vehicle::VehicleParameters car = type_a();
    car.wheelbase_m = 20.0;
    EXPECT_THROW(vehicle::check(car), parameters::ParameterError);
    EXPECT_NO_THROW(vehicle::check(type_a()));
}

}  // namespace
