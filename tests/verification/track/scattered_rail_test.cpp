// Receptances of tracks whose seats differ, from the waves that they scatter, against the elimination of every node.

#include "track/rail/scattered_rail.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "ballasted_track.hpp"
#include "tests/unit/track/wei2016_track.hpp"
#include "track/pads/pad_positions.hpp"

namespace {

using namespace railpem;
using namespace railpem::track;

ExactRail loaded(const TrackParameters& track, const std::vector<double>& wheels) {
    return exact_rail(track, wheels,
                      static_equilibrium(track, wheels, wei2016_wheel_load_n, pad_positions(track, wheels, 0)));
}

lanes::Real lines_about(double frequency) {
    lanes::Real omega{};
    for (int lane = 0; lane < lanes::width; ++lane)
        omega[lane] = 2.0 * std::numbers::pi * frequency * (1.0 + 0.1 * lane);
    return omega;
}

/// Receptances and sums of pad forces of one rail both ways, at one group of lines.
void expect_alike(const ExactRail& rail, double frequency) {
    const lanes::Real omega = lines_about(frequency);
    ExactRailWorkspace elimination(rail);
    const RailReceptance& expected = rail_receptance(rail, omega, elimination);
    const std::optional<ScatteredRail> scattered = scattered_rail(rail);
    ASSERT_TRUE(scattered);
    const SupportLaw law(rail.pads, rail.support, omega);
    ScatteredWorkspace workspace;
    RailReceptance found = expected;
    for (lanes::Complex& value : found.between) value = lanes::Complex{};
    ASSERT_TRUE(scattered_receptance(*scattered, bloch_waves(rail, omega, law), law, rail.uniform_pad_stiffness_n_per_m,
                                     workspace, found));
    for (int lane = 0; lane < lanes::width; ++lane)
        for (int i = 0; i < rail.points; ++i) {
            const std::complex<double> own = expected.at(i, i)[lane],
                                       sum = expected.trackbed[static_cast<std::size_t>(i)][lane];
            // Rounding, more of it where the waves are nearly alike (λ to 1e-3), and seats that count as alike below
            // 1e-10.
            EXPECT_NEAR(std::abs(found.trackbed[static_cast<std::size_t>(i)][lane] - sum), 0.0,
                        1e-9 * std::max(std::abs(sum), 1.0))
                << frequency << " " << i;
            for (int j = 0; j < rail.points; ++j)
                EXPECT_NEAR(std::abs(found.at(i, j)[lane] - expected.at(i, j)[lane]), 0.0, 1e-9 * std::abs(own))
                    << frequency << " " << i << j;
        }
}

constexpr double kFrequencies[] = {0.5, 5.0, 40.0, 80.0, 150.0, 300.0, 700.0, 1500.0};

TEST(ScatteredRail, IsTheEliminationOnLoadedPads) {
    for (TrackParameters track : {wei2016_track(), ballasted_track()})
        for (const double offset : {0.0, 0.2}) {
            track.wheel_offset_m = offset;
            for (const double frequency : kFrequencies) expect_alike(loaded(track, wei2016_wheels_m), frequency);
        }
}

TEST(ScatteredRail, IsTheEliminationOnFailedFasteners) {
    for (TrackParameters track : {wei2016_track(), ballasted_track()})
        for (const FailedFasteners& failed :
             {FailedFasteners{.every = 8, .first_seat = 3},
              FailedFasteners{.every = 2, .remaining_stiffness_fraction = 0.4}, FailedFasteners{.fraction = 0.3}}) {
            track.failed_fasteners = {failed};
            for (const double frequency : kFrequencies) expect_alike(loaded(track, wei2016_wheels_m), frequency);
        }
}

/// Wheels in any order, and at places of their own in their bays.
TEST(ScatteredRail, TakesPointsInAnyOrder) {
    TrackParameters track = wei2016_track();
    track.failed_fasteners = {{.every = 5}};
    for (const double frequency : kFrequencies) expect_alike(loaded(track, {8.1, -10.2, 10.2, -7.6}), frequency);
}

TEST(ScatteredRail, IsNothingWhereAllSeatsAreAlikeOrTwoPointsShareABay) {
    const TrackParameters track = wei2016_track();
    EXPECT_FALSE(scattered_rail(uniform_rail(track, wei2016_wheels_m, 30e6)));
    EXPECT_FALSE(scattered_rail(loaded(track, {10.4, 8.3, 8.1, -10.2})));
}

}  // namespace
