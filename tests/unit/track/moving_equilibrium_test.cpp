#include "track/statics/moving_equilibrium.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/track/wei2016_track.hpp"
#include "track/pads/pad_positions.hpp"

namespace railpem::track {
namespace {

const std::vector<double> kWheels{10.2, 7.8, -7.8, -10.2};
constexpr double kLoad_n = 80e3, kSpeed = 80.0 / 3.6;

TrackParameters creeping_track() {
    TrackParameters track = wei2016_track();
    track.pads.preload_strength = 1.0;
    track.pads.exponent = 0.15;
    track.pads.causal = true;
    return track;
}

TEST(PassingChange, IsCubicBetweenItsPointsAndNothingBeyond) {
    PassingChange change{.first_m = -2.0, .step_m = 0.5, .change_n_per_m = {}};
    const auto cubic = [](double x) { return 3.0 + x * (2.0 + x * (-1.5 + 0.7 * x)); };
    for (int i = 0; i <= 8; ++i) change.change_n_per_m.push_back(cubic(-2.0 + 0.5 * i));
    for (const double x : {-1.49, -0.3, 0.0, 0.77, 1.4}) EXPECT_NEAR(change.at(x), cubic(x), 1e-12) << x;
    EXPECT_EQ(change.at(-2.1), 0.0);
    EXPECT_EQ(change.at(2.3), 0.0);
    EXPECT_EQ(PassingChange{}.at(0.0), 0.0);
}

PassingChange change_at(const TrackParameters& track, double speed) {
    return passing_change(track, kWheels, kLoad_n, pad_history(track, kWheels, kLoad_n, speed));
}

// The pads under the second wheel of a bogie have not yet risen again: they are pressed further, and stiffer.
TEST(PassingChange, CreepStiffensThePadsUnderTheTrailingWheel) {
    const PassingChange change = change_at(creeping_track(), kSpeed);
    EXPECT_GT(change.at(7.8), change.at(10.2) + 1e6);
    EXPECT_GT(change.at(-10.2), change.at(-7.8) + 1e6);
}

// Pads without memory under a train that hardly moves: only the rail's inertia is left, (v/critical speed)² of what
// there is.
TEST(PassingChange, VanishesWithTheSpeed) {
    TrackParameters track = creeping_track();
    track.pads.exponent = 0.0;
    const double slow = std::abs(change_at(track, 0.1).at(10.2));
    EXPECT_LT(slow, 1e-2 * std::abs(change_at(track, kSpeed).at(10.2)));
}

// A wheel that passes meets the dynamic stiffness, 1.4 times the static one, which spreads its load: pads are pressed
// less than under a standing one.
TEST(MovingEquilibrium, LessLoadOnThePadUnderTheWheelThanAtRest) {
    TrackParameters track = creeping_track();
    track.statics.second_moment_of_area_m4 = 5.24e-6;
    const std::vector<double> pads = pad_positions(track, kWheels, 0);
    const StaticEquilibrium standing = static_equilibrium(track, kWheels, kLoad_n, pads);
    const StaticEquilibrium rolling = moving_equilibrium(track, kWheels, kLoad_n, pads, {});
    double most = 0.0, least = 1e300;
    for (std::size_t j = 0; j < pads.size(); ++j) {
        if (std::abs(pads[j] - 10.2) > 0.01) continue;
        most = standing.dynamic_stiffness_n_per_m[j];
        least = rolling.dynamic_stiffness_n_per_m[j];
    }
    EXPECT_LT(least, 0.95 * most);
    EXPECT_GT(least, standing.unloaded_dynamic_stiffness_n_per_m);
    EXPECT_NEAR(rolling.unloaded_dynamic_stiffness_n_per_m, standing.unloaded_dynamic_stiffness_n_per_m,
                1e-4 * standing.unloaded_dynamic_stiffness_n_per_m);
}

// Where load does not matter all pads stay alike.
TEST(MovingEquilibrium, LinearPadsStayAlike) {
    TrackParameters track = creeping_track();
    track.pads.force_polynomial_n.clear();
    const std::vector<double> pads = pad_positions(track, kWheels, 0);
    const PassingChange change = change_at(track, kSpeed);
    const StaticEquilibrium rolling = moving_equilibrium(track, kWheels, kLoad_n, pads, change);
    for (const double stiffness : rolling.dynamic_stiffness_n_per_m)
        EXPECT_NEAR(stiffness, 1.4 * 26.7e6, 1e-6 * 1.4 * 26.7e6);
}

}  // namespace
}  // namespace railpem::track
