#include "track/pads/pad_positions.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/track/wei2016_track.hpp"
#include "track/statics/static_equilibrium.hpp"

namespace railpem::track {
namespace {

TEST(PadPositions, PaperTrackIsSymmetricAboutTheCar) {
    const std::vector<double> pads = pad_positions(wei2016_track(), wei2016_wheels_m, 61);
    ASSERT_EQ(pads.size(), 61u);
    for (std::size_t j = 0; j < pads.size(); ++j) EXPECT_NEAR(pads[j], (static_cast<double>(j) - 30.0) * 0.6, 1e-12);
}

TEST(PadPositions, WheelOneStandsItsOffsetAheadOfSeatZero) {
    TrackParameters track = wei2016_track();
    track.wheel_offset_m = 0.25;
    for (const int count : {0, 60, 61}) {
        const std::vector<double> pads = pad_positions(track, wei2016_wheels_m, count);
        bool found = false;
        for (const double x : pads)
            if (seat_index(track, wei2016_wheels_m, x) == 0) {
                found = true;
                EXPECT_NEAR(x, 10.2 - 0.25, 1e-12);
            }
        EXPECT_TRUE(found);
        EXPECT_LE(std::abs(pads.front() + pads.back()) / 2.0, 0.3 + 1e-9) << "centred within half a bay";
        for (std::size_t j = 1; j < pads.size(); ++j) {
            EXPECT_NEAR(pads[j] - pads[j - 1], 0.6, 1e-12);
            EXPECT_EQ(seat_index(track, wei2016_wheels_m, pads[j]),
                      seat_index(track, wei2016_wheels_m, pads[j - 1]) + 1);
        }
    }
}

TEST(PadPositions, EndlessTrackReachesAsFarAsTheWheelsAreFelt) {
    TrackParameters hanging = wei2016_track();
    hanging.statics.clip_preload_n = 0.0;  // unloaded pads are soft then, and the wheels reach farther
    TrackParameters ballasted = wei2016_track();
    ballasted.support = {SupportModel::two_layer, 150.0, 20e6, 0.0, 0.0, {}};
    TrackParameters shear = wei2016_track();
    shear.rail.beam = Beam::timoshenko;
    for (const TrackParameters& track : {wei2016_track(), wei2016_track_as_published(), hanging, ballasted, shear}) {
        const std::vector<double> pads = pad_positions(track, wei2016_wheels_m, 0);
        const StaticEquilibrium found = static_equilibrium(track, wei2016_wheels_m, wei2016_wheel_load_n, pads);
        // 1e-10 for the smeared foundation; discrete, uplifted or shearing track is felt a little farther: two decades
        // more.
        for (const double end : {found.compression_m.front(), found.compression_m.back()})
            EXPECT_NEAR(end / found.unloaded_compression_m, 1.0, 1e-8);
        EXPECT_LT(pads.size(), 200u);
    }
}

TEST(PadPositions, FailedFastenersMakeTheWheelsReachFarther) {
    TrackParameters failed = wei2016_track();
    failed.failed_fasteners = {{.every = 2, .remaining_stiffness_fraction = 0.0}};
    const double sound_reach = pad_positions(wei2016_track(), wei2016_wheels_m, 0).back() - 10.2;
    const double failed_reach = pad_positions(failed, wei2016_wheels_m, 0).back() - 10.2;
    EXPECT_NEAR(failed_reach / sound_reach, std::pow(2.0, 0.25), 0.6 / sound_reach);  // half the foundation, to a bay
}

}  // namespace
}  // namespace railpem::track
