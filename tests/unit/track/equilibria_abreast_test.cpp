// Equilibria side by side against each one alone.

#include "track/statics/equilibria_abreast.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/unit/track/wei2016_track.hpp"

namespace railpem::track {
namespace {

/// Both end when the loads balance to 1e-10, and the softest thing that they balance on is a pad: 1e-9 of the largest
/// value.
constexpr double kSame = 1e-9;

/// Residual of an equilibrium that was found abreast, by the one that starts there: it has nothing left to do.
void expect_each_as_alone(const TrackParameters& track, double load_n, const std::vector<int>& first_seats,
                          const std::vector<StaticEquilibrium>& start = {}) {
    const std::vector<double> pads = pad_positions(track, wei2016_wheels_m, 0);
    const std::vector<StaticEquilibrium> found =
        equilibria_abreast(track, wei2016_wheels_m, load_n, pads, first_seats, start);
    ASSERT_EQ(found.size(), first_seats.size());
    for (std::size_t s = 0; s < found.size(); ++s) {
        TrackParameters alone = track;
        alone.failed_fasteners.front().first_seat = first_seats[s];
        const StaticEquilibrium expected = static_equilibrium(alone, wei2016_wheels_m, load_n, pads);
        const double largest = *std::max_element(expected.compression_m.begin(), expected.compression_m.end());
        EXPECT_EQ(found[s].remaining_fraction, expected.remaining_fraction);
        EXPECT_EQ(found[s].position_m, expected.position_m);
        for (std::size_t j = 0; j < pads.size(); ++j) {
            EXPECT_NEAR(found[s].compression_m[j], expected.compression_m[j], kSame * largest) << s << ", " << j;
            EXPECT_NEAR(found[s].dynamic_stiffness_n_per_m[j], expected.dynamic_stiffness_n_per_m[j],
                        10.0 * kSame * expected.unloaded_dynamic_stiffness_n_per_m)
                << s << ", " << j;
        }
        EXPECT_DOUBLE_EQ(found[s].unloaded_dynamic_stiffness_n_per_m, expected.unloaded_dynamic_stiffness_n_per_m);
        EXPECT_DOUBLE_EQ(found[s].unloaded_compression_m, expected.unloaded_compression_m);
    }
}

TEST(EquilibriaAbreast, EachIsTheOneAlone) {
    TrackParameters track = wei2016_track_as_published();
    track.failed_fasteners = {{.every = 8}};
    expect_each_as_alone(track, wei2016_wheel_load_n, {0, -1, -2, -3, -4, -5, -6, -7});
    expect_each_as_alone(track, wei2016_wheel_load_n, {3});
    track.failed_fasteners = {{.every = 2, .remaining_stiffness_fraction = 0.4}};
    track.support = {.model = SupportModel::two_layer, .mass_kg = 150.0, .stiffness_n_per_m = 60e6, .loss_factor = 0.5};
    expect_each_as_alone(track, wei2016_wheel_load_n, {0, 1, 2, 3, 4});
}

TEST(EquilibriaAbreast, WhereTheyBeginDoesNotMatter) {
    TrackParameters track = wei2016_track();
    track.failed_fasteners = {{.every = 3}};
    const std::vector<int> seats{0, -1, -2};
    track.wheel_offset_m = 0.05;
    const std::vector<StaticEquilibrium> behind = equilibria_abreast(track, wei2016_wheels_m, wei2016_wheel_load_n,
                                                                     pad_positions(track, wei2016_wheels_m, 0), seats);
    track.wheel_offset_m = 0.1;
    expect_each_as_alone(track, wei2016_wheel_load_n, seats, behind);
}

/// Measured points in place of the polynomial, the end of the curve passed, and a rail that lifts off: the full steps
/// of the common iteration may not get there, and what it does not find is solved alone.
TEST(EquilibriaAbreast, PointsLiftOffAndTheEndOfTheCurve) {
    TrackParameters track = wei2016_track();
    track.failed_fasteners = {{.every = 4}};
    track.statics.clip_preload_n = 500.0;
    expect_each_as_alone(track, 400e3, {0, 1, 2, 3});
    track.pads.force_polynomial_n.clear();
    track.pads.curve_compression_m = {0.0, 1e-3, 2e-3, 3e-3};
    track.pads.curve_force_n = {0.0, 10e3, 30e3, 80e3};
    expect_each_as_alone(track, wei2016_wheel_load_n, {0, 1, 2, 3});
    expect_each_as_alone(track, 400e3, {0, 1, 2, 3});
}

}  // namespace
}  // namespace railpem::track
