// A constant real correction is a scaled parameter.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "tests/unit/lanes/in_turn.hpp"
#include "vehicle/half_vehicle.hpp"

namespace railpem::vehicle {
namespace {

const lanes::FactorCurve by_1_2{.frequency_hz = {30.0}, .value = {1.2}};

/// A car and what it differs by from its parameters.
struct Car : VehicleParameters {
    VehicleModifiers modifiers;
};

HalfVehicle built(const Car& car) {
    return half_vehicle(car, car.modifiers);
}

Car car() {
    Car v;
    v.body_mass_kg = 38500;
    v.body_pitch_inertia_kg_m2 = 2.5e6;
    v.bogie_mass_kg = 2980;
    v.bogie_pitch_inertia_kg_m2 = 3.6e3;
    v.wheelset_mass_kg = 1350;
    v.bogie_distance_m = 18.0;
    v.wheelbase_m = 2.4;
    v.primary = {.stiffness_n_per_m = 2.1e6, .damping_n_s_per_m = 4.9e4, .damper_series_stiffness_n_per_m = 8e6};
    v.secondary = {.stiffness_n_per_m = 2.5e6, .damping_n_s_per_m = 2.0e5};
    v.body_bending = {{}};
    v.wheelset_bending = {{}};
    v.bogie_mounted_masses = {{}};
    return v;
}

void scale(SuspensionParameters& law) {
    law.stiffness_n_per_m *= 1.2;
    law.damping_n_s_per_m *= 1.2;
    law.damper_series_stiffness_n_per_m *= 1.2;
}

struct Correction {
    const char* name;
    std::function<void(Car&)> correct, reference;
};

class VehicleCorrection : public testing::TestWithParam<Correction> {};

TEST_P(VehicleCorrection, EqualsTheScaledParameter) {
    Car corrected = car(), scaled = car();
    GetParam().correct(corrected);
    GetParam().reference(scaled);
    const HalfVehicle plain_car = built(car()), corrected_car = built(corrected), scaled_car = built(scaled);
    Workspace plain_work(plain_car), corrected_work(corrected_car), scaled_work(scaled_car);
    const lanes::Real omega = lanes::tests::in_turn({4.0, 30.0, 170.0, 900.0});
    const WheelReceptance plain = wheel_receptance(plain_car, omega, plain_work);
    const WheelReceptance found = wheel_receptance(corrected_car, omega, corrected_work);
    const WheelReceptance expected = wheel_receptance(scaled_car, omega, scaled_work);
    double change = 0.0;
    for (std::size_t place = 0; place < found.at.size(); ++place)
        for (std::size_t wheel = 0; wheel < 4; ++wheel)
            for (int lane = 0; lane < lanes::width; ++lane) {
                const double size = std::abs(expected.at[place][wheel][lane]);
                // Rounding of the entries times the condition of D.
                EXPECT_NEAR(std::abs(found.at[place][wheel][lane] - expected.at[place][wheel][lane]), 0.0, 1e-12 * size)
                    << place << wheel << lane;
                change =
                    std::max(change, std::abs(plain.at[place][wheel][lane] - expected.at[place][wheel][lane]) / size);
            }
    EXPECT_GT(change, 0.01) << "the correction must be felt";
}

INSTANTIATE_TEST_SUITE_P(Places, VehicleCorrection,
                         testing::Values(Correction{"primary", [](Car& v) { v.modifiers.primary = by_1_2; },
                                                    [](Car& v) { scale(v.primary); }},
                                         Correction{"secondary", [](Car& v) { v.modifiers.secondary = by_1_2; },
                                                    [](Car& v) { scale(v.secondary); }},
                                         Correction{"body", [](Car& v) { v.modifiers.body = by_1_2; },
                                                    [](Car& v) {
                                                        v.body_mass_kg *= 1.2;
                                                        v.body_pitch_inertia_kg_m2 *= 1.2;
                                                    }},
                                         Correction{"bogie", [](Car& v) { v.modifiers.bogies = by_1_2; },
                                                    [](Car& v) {
                                                        v.bogie_mass_kg *= 1.2;
                                                        v.bogie_pitch_inertia_kg_m2 *= 1.2;
                                                    }},
                                         Correction{"wheel", [](Car& v) { v.modifiers.wheelsets = by_1_2; },
                                                    [](Car& v) { v.wheelset_mass_kg *= 1.2; }}),
                         [](const auto& tested) { return std::string(tested.param.name); });

/// Largest difference of the receptances between wheels, relative to the largest of them; `mirrored`: of the second car
/// seen from its other end.
double difference(const Car& first, const Car& second, bool mirrored) {
    const HalfVehicle one = built(first), other = built(second);
    Workspace one_work(one), other_work(other);
    const lanes::Real omega = lanes::tests::in_turn({4.0, 30.0, 170.0, 900.0});
    const WheelReceptance a = wheel_receptance(one, omega, one_work), b = wheel_receptance(other, omega, other_work);
    double largest = 0.0, size = 0.0;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            for (int lane = 0; lane < lanes::width; ++lane) {
                size = std::max(size, std::abs(a.wheel(i, j)[lane]));
                largest = std::max(
                    largest, std::abs(a.wheel(i, j)[lane] - (mirrored ? b.wheel(3 - i, 3 - j) : b.wheel(i, j))[lane]));
            }
    return largest / size;
}

TEST(CorrectionOfASingleOne, OnAllOfThemIsTheCorrectionOfTheKind) {
    Car kind = car(), each = car();
    kind.modifiers.wheelsets = kind.modifiers.bogies = by_1_2;
    each.modifiers.one_wheelset.fill(by_1_2);
    each.modifiers.one_bogie.fill(by_1_2);
    EXPECT_LE(difference(kind, each, false), 1e-13);
}

TEST(CorrectionOfASingleOne, IsMirroredByTheOtherEndAndIsNotTheNextOne) {
    Car first = car(), second = car(), last = car();
    first.modifiers.one_wheelset[0] = first.modifiers.one_bogie[0] = by_1_2;
    last.modifiers.one_wheelset[3] = last.modifiers.one_bogie[1] = by_1_2;
    second.modifiers.one_wheelset[1] = second.modifiers.one_bogie[0] = by_1_2;
    EXPECT_LE(difference(first, last, true), 1e-12);
    EXPECT_GT(difference(first, last, false), 0.01);
    EXPECT_GT(difference(first, second, false), 0.01);
}

Attachments at_both_ends(const lanes::FactorCurve& curve) {
    return {.centre = {}, .front = curve, .rear = curve};
}

TEST(Attachment, AtFrontAndRearIsInertiaAgainstBothMotions) {
    // (z + rθ)² + (z − rθ)² = 2(z² + r²θ²): a tenth of the mass at each end is a fifth of mass and pitch inertia.
    const lanes::FactorCurve tenth{.frequency_hz = {30.0}, .value = {0.1}};
    Car attached = car(), heavier = car();
    attached.modifiers.body_attachments = at_both_ends(tenth);
    heavier.modifiers.body = by_1_2;
    EXPECT_LE(difference(attached, heavier, false), 1e-13);
    EXPECT_GT(difference(attached, car(), false), 0.01);
}

TEST(Attachment, AtTheCentreIsMassAlone) {
    const lanes::FactorCurve fifth{.frequency_hz = {30.0}, .value = {0.2}};
    Car attached = car(), heavier = car();
    attached.modifiers.body_attachments.centre = fifth;
    heavier.body_mass_kg *= 1.2;
    EXPECT_LE(difference(attached, heavier, false), 1e-13);
}

TEST(Attachment, AtOneEndIsMirroredByTheOther) {
    const lanes::FactorCurve half{.frequency_hz = {30.0}, .value = {0.5}};
    Car front = car(), rear = car();
    front.modifiers.body_attachments.front = half;
    rear.modifiers.body_attachments.rear = half;
    EXPECT_LE(difference(front, rear, true), 1e-12);
    EXPECT_GT(difference(front, rear, false), 0.01);
}

TEST(Attachment, BetweenTheBogiesHoldsThemTogether) {
    // A mass 1e9 times the bogie's on their difference in heave: both heave alike, whatever wheel is pushed.
    Car held = car();
    held.modifiers.between_bogies.centre = {.frequency_hz = {30.0}, .value = {1e9}};
    const HalfVehicle model = built(held);
    Workspace work(model);
    const WheelReceptance found = wheel_receptance(model, lanes::tests::in_turn({4.0, 30.0, 170.0, 900.0}), work);
    for (std::size_t wheel = 0; wheel < 4; ++wheel)
        for (int lane = 0; lane < lanes::width; ++lane) {
            const std::complex<double> first = found.at[static_cast<int>(Place::bogie_1)][wheel][lane],
                                       second = found.at[static_cast<int>(Place::bogie_2)][wheel][lane];
            EXPECT_LE(std::abs(first - second), 1e-6 * std::abs(first));
        }
}

TEST(Attachment, AtTheFrontHoldsTheFront) {
    // 1e9 times the body's mass a radius of gyration (8.1 m) ahead of its centre: it turns about that point, and the
    // front pivot (9 m) hardly moves.
    Car held = car();
    held.body_bending.clear();
    held.modifiers.body_attachments.front = {.frequency_hz = {30.0}, .value = {1e9}};
    const HalfVehicle model = built(held);
    Workspace work(model);
    const WheelReceptance found = wheel_receptance(model, lanes::tests::in_turn({4.0, 30.0, 170.0, 900.0}), work);
    const auto &front = found.at[static_cast<int>(Place::body_front)],
               &rear = found.at[static_cast<int>(Place::body_rear)];
    for (int lane = 0; lane < lanes::width; ++lane) EXPECT_LT(std::abs(front[3][lane]), 0.1 * std::abs(rear[3][lane]));
}

TEST(Attachment, BetweenTheBogiesActsTowardsTheMiddleOfTheCar) {
    // (z₁ + rθ₁) − (z₂ − rθ₂): at the front of bogie 1 and at the rear of bogie 2, so that the outer wheels feel it
    // more than the inner ones.
    Car outer = car(), inner = car();
    outer.modifiers.between_bogies.front =
        inner.modifiers.between_bogies.rear = {.frequency_hz = {30.0}, .value = {1e3}};
    EXPECT_LE(difference(outer, outer, true), 1e-9);
    const HalfVehicle held_outside = built(outer), held_inside = built(inner);
    Workspace outside_work(held_outside), inside_work(held_inside);
    const lanes::Real omega = lanes::tests::in_turn({4.0, 30.0, 170.0, 900.0});
    const WheelReceptance outside = wheel_receptance(held_outside, omega, outside_work),
                          inside = wheel_receptance(held_inside, omega, inside_work);
    // at 900 rad/s the bogies are free
    const auto transmitted = [](const WheelReceptance& own, std::size_t wheel) {
        return std::abs(own.at[static_cast<int>(Place::bogie_2)][wheel][3]);
    };
    EXPECT_GT(transmitted(outside, 0), 3.0 * transmitted(outside, 1));
    EXPECT_GT(transmitted(inside, 1), 3.0 * transmitted(inside, 0));
}

TEST(SuspensionCorrection, ActsOnFrictionTooAndAtItsOwnFrequency) {
    const SuspensionParameters law{.stiffness_n_per_m = 2.1e6, .damping_n_s_per_m = 4.9e4};
    const lanes::Real omega = lanes::tests::in_turn({4.0, 30.0, 170.0, 900.0});
    const lanes::Complex plain = suspension_stiffness(law, 1e4, omega);
    const lanes::FactorCurve factor{.frequency_hz = {1.0, 100.0}, .value = {{1.0, 0.1}, {1.5, -0.2}}};
    const lanes::Complex found = suspension_stiffness(law, 1e4, omega, factor);
    for (int lane = 0; lane < lanes::width; ++lane)
        EXPECT_NEAR(std::abs(found[lane] / plain[lane] - factor.at(omega[lane])), 0.0, 1e-15);
}

}  // namespace
}  // namespace railpem::vehicle
