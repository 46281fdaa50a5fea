#include "track/pads/pad_scale.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/track/wei2016_track.hpp"

namespace railpem::track {
namespace {

TEST(PadScale, SoundTrackIsWhole) {
    EXPECT_EQ(pad_scale(wei2016_track(), 0), 1.0);
    EXPECT_EQ(mean_pad_scale(wei2016_track()), 1.0);
}

TEST(PadScale, EveryNthSeatInBothDirections) {
    const FailedFasteners failed{.every = 4, .remaining_stiffness_fraction = 0.1};
    for (int seat = -12; seat <= 12; ++seat) EXPECT_EQ(pad_scale(failed, seat), seat % 4 == 0 ? 0.1 : 1.0) << seat;
}

TEST(PadScale, RandomShareIsRightAndUncorrelated) {
    for (const int seed : {1, 2, 77}) {
        const FailedFasteners failed{.fraction = 0.2, .seed = seed};
        const int n = 100000;
        double share = 0.0, pairs = 0.0;
        for (int seat = -n / 2; seat < n / 2; ++seat) {
            const bool gone = pad_scale(failed, seat) == 0.0, next = pad_scale(failed, seat + 1) == 0.0;
            share += gone ? 1.0 / n : 0.0;
            pairs += gone && next ? 1.0 / n : 0.0;
        }
        // Binomial standard deviations: √(0.2·0.8/n) = 0.0013 and, for the pairs, less than √(0.04·1.5/n) = 0.0008;
        // five of each.
        EXPECT_NEAR(share, 0.2, 0.0065);
        EXPECT_NEAR(pairs, 0.04, 0.004);
    }
}

TEST(PadScale, SeedsDrawDifferentSeatsAndRepeatTheirOwn) {
    const FailedFasteners one{.fraction = 0.3, .seed = 1}, two{.fraction = 0.3, .seed = 2};
    int different = 0;
    for (int seat = 0; seat < 1000; ++seat) {
        EXPECT_EQ(pad_scale(one, seat), pad_scale(one, seat));
        different += pad_scale(one, seat) != pad_scale(two, seat) ? 1 : 0;
    }
    EXPECT_NEAR(different, 420, 5 * 16);  // 2·0.3·0.7·1000, five binomial standard deviations
}

TEST(PadScale, MeanCountsBothKindsOnce) {
    TrackParameters track = wei2016_track();
    track.failed_fasteners = {{.every = 5, .fraction = 0.25, .remaining_stiffness_fraction = 0.2, .seed = 3}};
    double mean = 0.0;
    const int n = 100000;
    for (int seat = 0; seat < n; ++seat) mean += pad_scale(track, seat) / n;
    EXPECT_NEAR(mean_pad_scale(track), mean, 5 * 0.8 * std::sqrt(0.4 * 0.6 / n));
}

}  // namespace
}  // namespace railpem::track
