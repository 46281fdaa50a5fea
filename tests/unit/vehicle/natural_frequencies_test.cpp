#include "vehicle/natural_frequencies.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace railpem::vehicle {
namespace {

/// A car on bogies so heavy and stiffly held that only its body moves.
VehicleParameters body_alone() {
    VehicleParameters car{.body_mass_kg = 40e3,
                          .body_pitch_inertia_kg_m2 = 2e6,
                          .bogie_mass_kg = 3e3,
                          .bogie_pitch_inertia_kg_m2 = 4e3,
                          .wheelset_mass_kg = 1.5e3,
                          .bogie_distance_m = 18.0,
                          .wheelbase_m = 2.5};
    car.primary = {.stiffness_n_per_m = 1e13};
    car.secondary = {.stiffness_n_per_m = 4e5, .damping_n_s_per_m = 2e4};
    return car;
}

constexpr double kRigidGround = 1e14;  // N/m
constexpr double kTwo_pi = 2.0 * std::numbers::pi;

/// Bounce sqrt(4k/M), pitch sqrt(4k·b²/J) with b half the bogie distance; damping c/(2·sqrt(k·m)) of either. The ground
/// gives way by 1e-8 of the springs.
TEST(NaturalFrequencies, OfABodyOnItsSpringsAreInClosedForm) {
    const VehicleParameters car = body_alone();
    const auto found = natural_frequencies(half_vehicle(car), kRigidGround);
    ASSERT_GE(found.size(), 2u);
    const double k = 4.0 * car.secondary.stiffness_n_per_m, c = 4.0 * car.secondary.damping_n_s_per_m;
    const double bounce = std::sqrt(k / car.body_mass_kg), pitch = std::sqrt(k * 81.0 / car.body_pitch_inertia_kg_m2);
    EXPECT_EQ(found[0].motion, Motion::body_bounce);
    EXPECT_NEAR(found[0].frequency_hz * kTwo_pi / bounce, 1.0, 1e-6);
    EXPECT_NEAR(found[0].damping_ratio, c / (2.0 * std::sqrt(k * car.body_mass_kg)), 1e-6);
    EXPECT_EQ(found[1].motion, Motion::body_pitch);
    EXPECT_NEAR(found[1].frequency_hz * kTwo_pi / pitch, 1.0, 1e-6);
}

TEST(NaturalFrequencies, WithoutDampersAreNotDamped) {
    VehicleParameters car = body_alone();
    car.secondary.damping_n_s_per_m = 0.0;
    for (const NaturalFrequency& natural : natural_frequencies(half_vehicle(car), kRigidGround))
        EXPECT_EQ(natural.damping_ratio, 0.0);
}

/// A damper behind a soft spring damps less: of a series stiffness that is a thousandth of the spring's nothing is left
/// but a thousandth.
TEST(NaturalFrequencies, ADamperBehindASoftSpringDampsLess) {
    VehicleParameters car = body_alone();
    car.secondary.damper_series_stiffness_n_per_m = 4e2;
    EXPECT_LT(natural_frequencies(half_vehicle(car), kRigidGround)[0].damping_ratio, 1e-3);
    car.secondary.damper_series_stiffness_n_per_m = 4e12;
    const double rigid = natural_frequencies(half_vehicle(body_alone()), kRigidGround)[0].damping_ratio;
    EXPECT_NEAR(natural_frequencies(half_vehicle(car), kRigidGround)[0].damping_ratio / rigid, 1.0, 1e-5);
}

}  // namespace
}  // namespace railpem::vehicle
