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

VehicleParameters car() {
    VehicleParameters v;
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
    std::function<void(VehicleParameters&)> correct, reference;
};

class VehicleCorrection : public testing::TestWithParam<Correction> {};

TEST_P(VehicleCorrection, EqualsTheScaledParameter) {
    VehicleParameters corrected = car(), scaled = car();
    GetParam().correct(corrected);
    GetParam().reference(scaled);
    const HalfVehicle plain_car = half_vehicle(car()), corrected_car = half_vehicle(corrected),
                      scaled_car = half_vehicle(scaled);
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

INSTANTIATE_TEST_SUITE_P(
    Places, VehicleCorrection,
    testing::Values(Correction{"primary", [](VehicleParameters& v) { v.primary.correction = by_1_2; },
                               [](VehicleParameters& v) { scale(v.primary); }},
                    Correction{"secondary", [](VehicleParameters& v) { v.secondary.correction = by_1_2; },
                               [](VehicleParameters& v) { scale(v.secondary); }},
                    Correction{"body", [](VehicleParameters& v) { v.body_correction = by_1_2; },
                               [](VehicleParameters& v) {
                                   v.body_mass_kg *= 1.2;
                                   v.body_pitch_inertia_kg_m2 *= 1.2;
                               }},
                    Correction{"bogie", [](VehicleParameters& v) { v.bogie_correction = by_1_2; },
                               [](VehicleParameters& v) {
                                   v.bogie_mass_kg *= 1.2;
                                   v.bogie_pitch_inertia_kg_m2 *= 1.2;
                               }},
                    Correction{"wheel", [](VehicleParameters& v) { v.wheel_correction = by_1_2; },
                               [](VehicleParameters& v) { v.wheelset_mass_kg *= 1.2; }}),
    [](const auto& tested) { return std::string(tested.param.name); });

/// Largest difference of the receptances between wheels, relative to the largest of them; `mirrored`: of the second car
/// seen from its other end.
double difference(const VehicleParameters& first, const VehicleParameters& second, bool mirrored) {
    const HalfVehicle one = half_vehicle(first), other = half_vehicle(second);
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
    VehicleParameters kind = car(), each = car();
    kind.wheel_correction = kind.bogie_correction = by_1_2;
    each.one_wheelset_correction.fill(by_1_2);
    each.one_bogie_correction.fill(by_1_2);
    EXPECT_LE(difference(kind, each, false), 1e-13);
}

TEST(CorrectionOfASingleOne, IsMirroredByTheOtherEndAndIsNotTheNextOne) {
    VehicleParameters first = car(), second = car(), last = car();
    first.one_wheelset_correction[0] = first.one_bogie_correction[0] = by_1_2;
    last.one_wheelset_correction[3] = last.one_bogie_correction[1] = by_1_2;
    second.one_wheelset_correction[1] = second.one_bogie_correction[0] = by_1_2;
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
    VehicleParameters attached = car(), heavier = car();
    attached.body_attachments = at_both_ends(tenth);
    heavier.body_correction = by_1_2;
    EXPECT_LE(difference(attached, heavier, false), 1e-13);
    EXPECT_GT(difference(attached, car(), false), 0.01);
}

TEST(Attachment, AtTheCentreIsMassAlone) {
    const lanes::FactorCurve fifth{.frequency_hz = {30.0}, .value = {0.2}};
    VehicleParameters attached = car(), heavier = car();
    attached.body_attachments.centre = fifth;
    heavier.body_mass_kg *= 1.2;
    EXPECT_LE(difference(attached, heavier, false), 1e-13);
}

TEST(Attachment, AtOneEndIsMirroredByTheOther) {
    const lanes::FactorCurve half{.frequency_hz = {30.0}, .value = {0.5}};
    VehicleParameters front = car(), rear = car();
    front.body_attachments.front = half;
    rear.body_attachments.rear = half;
    EXPECT_LE(difference(front, rear, true), 1e-12);
    EXPECT_GT(difference(front, rear, false), 0.01);
}

TEST(Attachment, BetweenTheBogiesHoldsThemTogether) {
    // A mass 1e9 times the bogie's on their difference in heave: both heave alike, whatever wheel is pushed.
    VehicleParameters held = car();
    held.between_bogies.centre = {.frequency_hz = {30.0}, .value = {1e9}};
    const HalfVehicle model = half_vehicle(held);
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
    VehicleParameters held = car();
    held.body_bending.clear();
    held.body_attachments.front = {.frequency_hz = {30.0}, .value = {1e9}};
    const HalfVehicle model = half_vehicle(held);
    Workspace work(model);
    const WheelReceptance found = wheel_receptance(model, lanes::tests::in_turn({4.0, 30.0, 170.0, 900.0}), work);
    const auto &front = found.at[static_cast<int>(Place::body_front)],
               &rear = found.at[static_cast<int>(Place::body_rear)];
    for (int lane = 0; lane < lanes::width; ++lane) EXPECT_LT(std::abs(front[3][lane]), 0.1 * std::abs(rear[3][lane]));
}

TEST(Attachment, BetweenTheBogiesActsTowardsTheMiddleOfTheCar) {
    // (z₁ + rθ₁) − (z₂ − rθ₂): at the front of bogie 1 and at the rear of bogie 2, so that the outer wheels feel it
    // more than the inner ones.
    VehicleParameters outer = car(), inner = car();
    outer.between_bogies.front = inner.between_bogies.rear = {.frequency_hz = {30.0}, .value = {1e3}};
    EXPECT_LE(difference(outer, outer, true), 1e-9);
    const HalfVehicle held_outside = half_vehicle(outer), held_inside = half_vehicle(inner);
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
    SuspensionParameters law{.stiffness_n_per_m = 2.1e6, .damping_n_s_per_m = 4.9e4};
    const lanes::Real omega = lanes::tests::in_turn({4.0, 30.0, 170.0, 900.0});
    const lanes::Complex plain = suspension_stiffness(law, 1e4, omega);
    law.correction = {.frequency_hz = {1.0, 100.0}, .value = {{1.0, 0.1}, {1.5, -0.2}}};
    const lanes::Complex found = suspension_stiffness(law, 1e4, omega);
    for (int lane = 0; lane < lanes::width; ++lane)
        EXPECT_NEAR(std::abs(found[lane] / plain[lane] - law.correction.at(omega[lane])), 0.0, 1e-15);
}

}  // namespace
}  // namespace railpem::vehicle
