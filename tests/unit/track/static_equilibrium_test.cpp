#include "track/statics/static_equilibrium.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "parameters/parameter_error.hpp"
#include "tests/unit/track/wei2016_track.hpp"
#include "track/pads/pad_curve.hpp"

namespace railpem::track {
namespace {

StaticEquilibrium equilibrium(const TrackParameters& track, int count = wei2016_pads,
                              double load_n = wei2016_wheel_load_n) {
    return static_equilibrium(track, wei2016_wheels_m, load_n, pad_positions(track, wei2016_wheels_m, count));
}

double largest(const std::vector<double>& values) {
    return *std::max_element(values.begin(), values.end());
}

double pad_forces_n(const TrackParameters& track, const StaticEquilibrium& found) {
    const PadCurve curve = pad_curve(track.pads);
    double sum = 0.0;
    for (std::size_t j = 0; j < found.position_m.size(); ++j)
        sum += found.remaining_fraction[j] * (pad_force(curve, found.compression_m[j]) - track.statics.clip_preload_n);
    return sum;
}

// Wei et al. 2016, Figures 4 and 5 and section 3: three quoted digits.
TEST(StaticEquilibrium, PublishedVariant) {
    const StaticEquilibrium found = equilibrium(wei2016_track_as_published());
    EXPECT_NEAR(largest(found.compression_m), 3.360e-3, 0.0005e-3);
    EXPECT_NEAR(largest(found.static_stiffness_n_per_m), 37.90e6, 0.005e6);
    EXPECT_NEAR(found.unloaded_compression_m, 1.78e-3, 0.01e-3);  // F(S) = 20.353 kN gives 1.7853, quoted as 1.78
    EXPECT_NEAR(found.unloaded_static_stiffness_n_per_m, 19.13e6, 0.005e6);
    EXPECT_TRUE(found.warnings.empty());
    // "Three groups of pads": the one under a wheel and its two neighbours carry visibly more than the others.
    const std::size_t wheel = 47;  // 10.2 m
    const double load = found.compression_m[wheel] - found.unloaded_compression_m;
    for (const std::size_t beside : {wheel - 1, wheel + 1})
        EXPECT_GT(found.compression_m[beside] - found.unloaded_compression_m, 0.4 * load);
    EXPECT_LT(found.compression_m[wheel + 2] - found.unloaded_compression_m, 0.1 * load);
}

TEST(StaticEquilibrium, ConsistentVariant) {
    const StaticEquilibrium found = equilibrium(wei2016_track());
    EXPECT_NEAR(largest(found.compression_m), 2.865e-3, 0.0005e-3);
    EXPECT_NEAR(largest(found.static_stiffness_n_per_m), 31.12e6, 0.005e6);
}

/// From a neighbour, wheels 5 cm away and fasteners failed in between, to the same equilibrium in fewer steps.
TEST(StaticEquilibrium, StartsFromANeighbour) {
    TrackParameters track = wei2016_track();
    const StaticEquilibrium neighbour = equilibrium(track);
    track.wheel_offset_m = 0.05;
    const std::vector<double> pads = pad_positions(track, wei2016_wheels_m, wei2016_pads);
    const StaticEquilibrium cold = static_equilibrium(track, wei2016_wheels_m, wei2016_wheel_load_n, pads);
    const StaticEquilibrium warm = static_equilibrium(track, wei2016_wheels_m, wei2016_wheel_load_n, pads, &neighbour);
    EXPECT_LT(warm.iterations, cold.iterations);
    for (std::size_t j = 0; j < pads.size(); ++j)
        EXPECT_NEAR(warm.compression_m[j], cold.compression_m[j], 1e-10 * largest(cold.compression_m));
}

TEST(StaticEquilibrium, NewtonConvergesQuadratically) {
    TrackParameters ballasted = wei2016_track();
    ballasted.support = {SupportModel::two_layer, 150.0, 60e6, 0.0, 0.0, {}};
    for (const TrackParameters& track : {wei2016_track(), wei2016_track_as_published(), ballasted}) {
        const StaticEquilibrium found = equilibrium(track);
        EXPECT_LE(found.residual_n, 1e-10 * 80e3);
        EXPECT_LE(found.iterations, 6) << "a wrong tangent would need many more";
        EXPECT_GE(found.iterations, 3);
    }
}

/// A pad that is stiff, then soft, then stiff again sends undamped Newton steps to and fro.
TEST(StaticEquilibrium, StepsThatOvershootAreCutBack) {
    TrackParameters track = wei2016_track_as_published();
    track.pads.force_polynomial_n.clear();
    track.pads.curve_compression_m = {0.0, 0.1e-3, 0.15e-3, 2.0e-3, 2.05e-3, 2.1e-3, 3e-3};
    track.pads.curve_force_n = {0.0, 20e3, 25e3, 26e3, 60e3, 85e3, 90e3};
    for (const double load : {20e3, 40e3, 80e3, 120e3}) {
        const StaticEquilibrium found = equilibrium(track, wei2016_pads, load);
        EXPECT_LE(found.residual_n, 1e-10 * 80e3);
        EXPECT_NEAR(pad_forces_n(track, found), 4 * load + 60.0 * 9.81 * 0.6 * wei2016_pads, 1e-3) << found.iterations;
    }
}

/// Linear pads on a linear support: the rail cannot tell them from one softer pad. The clips press inside the
/// fastening.
TEST(StaticEquilibrium, SupportInSeriesIsASofterPad) {
    TrackParameters ballasted = wei2016_track(), soft = wei2016_track();
    for (TrackParameters* track : {&ballasted, &soft}) {
        track->pads.force_polynomial_n.clear();
        track->pads.preload_strength = 0.0;
    }
    ballasted.support = {SupportModel::two_layer, 150.0, 60e6, 0.0, 0.0, {}};
    soft.pads.static_stiffness_n_per_m = 1.0 / (1.0 / 26.7e6 + 1.0 / 60e6);
    const StaticEquilibrium a = equilibrium(ballasted), b = equilibrium(soft);
    for (std::size_t j = 0; j < a.position_m.size(); ++j)
        EXPECT_NEAR(26.7e6 * a.compression_m[j], soft.pads.static_stiffness_n_per_m * b.compression_m[j], 1e-4);  // N
}

TEST(StaticEquilibrium, PadsCarryEverythingThatPresses) {
    TrackParameters ballasted = wei2016_track();
    ballasted.support = {SupportModel::two_layer, 150.0, 60e6, 0.0, 0.0, {}};
    TrackParameters failed = wei2016_track();
    failed.failed_fasteners = {{.every = 3, .remaining_stiffness_fraction = 0.0}};
    TrackParameters shear = wei2016_track();
    shear.rail.beam = Beam::timoshenko;
    for (const TrackParameters& track : {wei2016_track(), ballasted, failed, shear}) {
        const StaticEquilibrium found = equilibrium(track);
        const double weight = 60.0 * 9.81 * 0.6 * wei2016_pads;
        EXPECT_NEAR(pad_forces_n(track, found), 4 * 80e3 + weight, 1e-3);  // 61 residuals below 8e-6 N
    }
}

TEST(StaticEquilibrium, UnloadedTrackStaysUniform) {
    TrackParameters track = wei2016_track();
    const StaticEquilibrium found = equilibrium(track, wei2016_pads, 0.0);
    for (const double s : found.compression_m) EXPECT_NEAR(s, found.unloaded_compression_m, 1e-15);
    EXPECT_NEAR(pad_force(pad_curve(track.pads), found.unloaded_compression_m), 20e3 + 60.0 * 9.81 * 0.6, 1e-6);
}

TEST(StaticEquilibrium, SymmetricForASymmetricVehicle) {
    const StaticEquilibrium found = equilibrium(wei2016_track());
    for (std::size_t j = 0; j < 61; ++j) EXPECT_NEAR(found.compression_m[j], found.compression_m[60 - j], 1e-15);
}

TEST(StaticEquilibrium, WheelBetweenPadsMovesContinuously) {
    // No node stands under a wheel: a wheel a hair beside a pad must do what a wheel over it does.
    TrackParameters beside = wei2016_track();
    beside.wheel_offset_m = 1e-9;
    EXPECT_NEAR(largest(equilibrium(beside).compression_m), largest(equilibrium(wei2016_track()).compression_m), 1e-11);
    TrackParameters half = wei2016_track();
    half.wheel_offset_m = 0.3;
    EXPECT_LT(largest(equilibrium(half).compression_m), largest(equilibrium(wei2016_track()).compression_m));
}

TEST(StaticEquilibrium, PreloadStrengthBlendsTheStiffness) {
    TrackParameters track = wei2016_track();
    for (const double s : {0.0, 0.4, 1.0, 1.5}) {
        track.pads.preload_strength = s;
        const StaticEquilibrium found = equilibrium(track);
        for (const std::size_t j : {10u, 30u, 47u})
            EXPECT_NEAR(found.dynamic_stiffness_n_per_m[j],
                        1.4 * ((1.0 - s) * 26.7e6 + s * found.static_stiffness_n_per_m[j]), 1e-3);
        EXPECT_NEAR(found.unloaded_dynamic_stiffness_n_per_m,
                    1.4 * ((1.0 - s) * 26.7e6 + s * found.unloaded_static_stiffness_n_per_m), 1e-3);
    }
}

TEST(StaticEquilibrium, RailLiftsOffWithoutClips) {
    TrackParameters track = wei2016_track();
    track.statics.clip_preload_n = 0.0;
    track.pads.preload_strength = 1.5;
    const StaticEquilibrium found = equilibrium(track, 121);
    EXPECT_LE(found.residual_n, 1e-10 * 80e3);
    ASSERT_EQ(found.warnings.size(), 1u);
    EXPECT_NE(found.warnings[0].find("the rail lifts off"), std::string::npos) << found.warnings[0];
    const PadCurve curve = pad_curve(track.pads);
    int lifted = 0;
    for (std::size_t j = 0; j < found.position_m.size(); ++j)
        if (found.compression_m[j] <= curve.free_compression_m) {
            ++lifted;
            EXPECT_EQ(found.static_stiffness_n_per_m[j], 0.0);
            EXPECT_EQ(found.dynamic_stiffness_n_per_m[j], 0.0) << "cut at zero, not negative";
        }
    EXPECT_GE(lifted, 4);
    EXPECT_NEAR(pad_forces_n(track, found), 4 * 80e3 + 60.0 * 9.81 * 0.6 * 121, 1e-3);
}

TEST(StaticEquilibrium, SaysThatTheCurveWasLeft) {
    const StaticEquilibrium found = equilibrium(wei2016_track_as_published(), wei2016_pads, 200e3);
    ASSERT_EQ(found.warnings.size(), 1u);
    EXPECT_EQ(found.warnings[0], "4 pad(s) carry more than 90 kN, the end of the static curve; its tangent goes on");
}

TEST(StaticEquilibrium, ViolentLoadsStillConverge) {
    TrackParameters track = wei2016_track_as_published();
    track.statics.clip_preload_n = 0.0;
    for (const double load : {1e3, 1e6, 1e8})
        EXPECT_LE(equilibrium(track, 121, load).residual_n, 1e-10 * std::max(load, 1e3));
}

TEST(StaticEquilibrium, FailedSeatLoadsItsNeighbours) {
    TrackParameters track = wei2016_track();
    track.failed_fasteners = {{.every = 100, .remaining_stiffness_fraction = 0.0}};  // seat 0 only, under wheel 1
    const StaticEquilibrium sound = equilibrium(wei2016_track()), found = equilibrium(track);
    EXPECT_EQ(found.remaining_fraction[47], 0.0);
    EXPECT_GT(found.compression_m[46], 1.05 * sound.compression_m[46]);
    EXPECT_GT(found.compression_m[47], sound.compression_m[47]) << "the rail bends down where nothing carries it";
    EXPECT_NEAR(found.compression_m[13], sound.compression_m[13], 1e-9);
}

TEST(StaticEquilibrium, RefusesAWheelOffTheTrack) {
    try {
        equilibrium(wei2016_track(), 21);
        FAIL();
    } catch (const parameters::ParameterError& error) {
        EXPECT_EQ(error.key(), "solver.pads");
        EXPECT_EQ(error.problem(), "wheel 1 stands at 10.2 m, off the track, which reaches from -6.3 m to 6.3 m");
    }
}

}  // namespace
}  // namespace railpem::track
