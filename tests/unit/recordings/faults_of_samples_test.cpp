// Every fault of single channels, planted at a stated size, is found in the right channel, and nothing else is claimed
// that is not a consequence of it.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "faulty_record.hpp"
#include "recordings/inspection/inspection_words.hpp"

namespace railpem::recordings::testing {
namespace {

TEST(Faults, ASoundRecordHasNone) {
    const InspectionReport report = inspect(sound(), context());
    for (const Fault& fault : report.faults) ADD_FAILURE() << fault_name(fault.kind) << ": " << fault.says;
    EXPECT_EQ(verdict_of(report), "No fault was found.");
    EXPECT_NEAR(report.speed_m_per_s / settings().speed_m_per_s, 1.0, 0.002);
    // The noise that was put in bounds what the channels do not share from below. Axle boxes share less than all,
    // because the windows of 2 s do not hold all of a delay of 0.9 s; bogies and body come close.
    const double noise = 0.02 * std::sqrt((0.4 * 500.0 - 4.0) / 250.0);  // of white noise in the band of noise_rms
    for (const ChannelInspection& channel : report.channels) {
        EXPECT_GT(channel.noise_rms, 0.9 * noise) << channel.description.name;
        const double bound = channel.description.location == Location::wheel ? 50.0 : 1.3;
        EXPECT_LT(channel.noise_rms, bound * noise) << channel.description.name;
    }
}

TEST(Faults, MissingSamples) {
    Recording recording = sound();
    auto& x = samples(recording, "bogie_1");
    std::fill(x.begin() + 4000, x.begin() + 4040, std::nan(""));
    const auto faults = found(recording, FaultKind::missing_samples);
    ASSERT_NO_FATAL_FAILURE(expect_only(faults, "bogie_1"));
    EXPECT_NEAR(faults[0].from_s, 8.0, 1e-9);
    EXPECT_NEAR(faults[0].to_s, 8.08, 1e-9);
    EXPECT_TRUE(found(recording, FaultKind::impacts).empty());
}

TEST(Faults, HeldValues) {
    Recording recording = sound();
    auto& x = samples(recording, "axlebox_3");
    std::fill(x.begin() + 5000, x.begin() + 5025, x[5000]);
    const auto faults = found(recording, FaultKind::held_values);
    ASSERT_NO_FATAL_FAILURE(expect_only(faults, "axlebox_3"));
    EXPECT_NEAR(faults[0].from_s, 10.0, 1e-9);
}

TEST(Faults, RoundedChannelsAreNotHeldOrClipped) {
    Recording recording = sound();
    for (Channel& channel : recording.series.channels)
        for (double& x : channel.samples) x = 0.05 * std::round(x / 0.05);
    EXPECT_TRUE(found(recording, FaultKind::held_values).empty());
    EXPECT_TRUE(found(recording, FaultKind::clipping).empty());
}

TEST(Faults, CoarseResolution) {
    Recording recording = sound();
    auto& x = samples(recording, "axlebox_1");
    const double step = 0.5 * rms(x);
    for (double& v : x) v = step * std::round(v / step);
    ASSERT_NO_FATAL_FAILURE(expect_only(found(recording, FaultKind::coarse_resolution), "axlebox_1"));
}

TEST(Faults, FewDigitsAreNotHeldAndNotClipped) {
    Recording recording = sound();
    const double step = 1.5 * rms(samples(recording, "body_front"));
    for (const char* name : {"body_front", "body_rear", "axlebox_1"})
        for (double& v : samples(recording, name)) v = step * std::round(v / step);
    const InspectionReport report = inspect(recording, context());
    ASSERT_EQ(report.faults.size(), 2U);
    for (const Fault& fault : report.faults) {
        EXPECT_EQ(fault.kind, FaultKind::coarse_resolution) << fault.says;
        EXPECT_EQ(fault.severity, Severity::warning);
        EXPECT_NEAR(fault.value / step, 1.0, 1e-6);
    }
}

TEST(Faults, ClippingOnOneSideWithNoiseOfALaterStage) {
    for (const double side : {1.0, -1.0}) {
        Recording recording = make_record({.duration_s = 34.0, .seed = 5});
        auto& x = samples(recording, "axlebox_2");
        const double limit = 1.8 * rms(x);
        std::mt19937_64 generator(4);
        std::normal_distribution<double> normal(0.0, 0.001 * limit);
        for (double& v : x) v = side * std::min(side * v, limit) + normal(generator);
        const auto faults = found(recording, FaultKind::clipping);
        ASSERT_NO_FATAL_FAILURE(expect_only(faults, "axlebox_2"));
        EXPECT_TRUE(faults[0].says.starts_with(side > 0.0 ? "clipped on the upper" : "clipped on the lower"))
            << faults[0].says;
    }
}

TEST(Faults, Constant) {
    Recording recording = sound();
    auto& x = samples(recording, "body_rear");
    std::fill(x.begin(), x.end(), 0.3);
    ASSERT_NO_FATAL_FAILURE(expect_only(found(recording, FaultKind::constant), "body_rear"));
}

TEST(Faults, ClippingAtThreeStandardDeviations) {
    Recording recording = sound();
    auto& x = samples(recording, "axlebox_2");
    const double limit = 3.0 * rms(x);
    for (double& v : x) v = std::clamp(v, -limit, limit);
    const auto faults = found(recording, FaultKind::clipping);
    ASSERT_NO_FATAL_FAILURE(expect_only(faults, "axlebox_2"));
    EXPECT_NEAR(faults[0].value, 0.0027, 0.0015);
}

/// Limited, then through a filter of first order, as before sampling: where the limit held for long, too, no two values
/// are the same any more.
std::vector<double> limited_before_a_filter(std::vector<double> x, double limit) {
    for (double& v : x) v = std::clamp(v, -limit, limit);
    for (std::size_t n = 1; n < x.size(); ++n) x[n] = 0.3 * x[n - 1] + 0.7 * x[n];
    return x;
}

TEST(Faults, ClippingAtTwoStandardDeviationsBeforeAFilter) {
    Recording recording = make_record({.duration_s = 60.0, .seed = 5});
    auto& x = samples(recording, "axlebox_2");
    x = limited_before_a_filter(x, 2.0 * rms(x));
    const auto faults = found(recording, FaultKind::clipping);
    ASSERT_NO_FATAL_FAILURE(expect_only(faults, "axlebox_2"));
    EXPECT_TRUE(faults[0].says.starts_with("clipped before a filter")) << faults[0].says;
    EXPECT_LT(faults[0].value, 0.5);  // peaks less than half as different as random ones
}

TEST(Faults, TheFilterAloneIsNoClipping) {
    Recording recording = make_record({.duration_s = 60.0, .seed = 5});
    auto& x = samples(recording, "axlebox_2");
    x = limited_before_a_filter(x, 100.0 * rms(x));
    EXPECT_TRUE(found(recording, FaultKind::clipping).empty());
}

TEST(Faults, ALineIsNoClipping) {
    // The peaks of a sinusoid three times as strong as the rest are all alike.
    Recording recording = make_record({.duration_s = 60.0, .sampling_rate_hz = 500.0, .seed = 5});
    auto& x = samples(recording, "axlebox_2");
    const double amplitude = 3.0 * std::numbers::sqrt2 * rms(x);
    for (std::size_t n = 0; n < x.size(); ++n)
        x[n] += amplitude * std::sin(2.0 * std::numbers::pi * 31.0 * static_cast<double>(n) / 500.0);
    EXPECT_TRUE(found(recording, FaultKind::clipping).empty());
}

TEST(Faults, PolarityOfALoneBodyChannelIsSaidToBeUndecided) {
    Recording recording = sound();
    std::erase_if(recording.series.channels,
                  [](const Channel& channel) { return channel.description.name != "body_centre"; });
    ASSERT_EQ(recording.series.channels.size(), 1U);
    const auto said = inspect(recording, {}).not_checked;
    EXPECT_TRUE(std::any_of(said.begin(), said.end(), [](const std::string& words) {
        return words.rfind("polarity and timing of body_centre", 0) == 0;
    }));
}

// Its delays to the others are lost in noise: that nothing is said of its sign is no proof that it is right.
TEST(Faults, AnAxleBoxWithoutDelaysIsSaidToBeUnchecked) {
    Recording recording = sound();
    const auto unchecked = [](const InspectionReport& report) {
        return std::any_of(report.not_checked.begin(), report.not_checked.end(), [](const std::string& words) {
            return words.rfind("timing, order and polarity of axlebox_2 by delays", 0) == 0;
        });
    };
    EXPECT_FALSE(unchecked(inspect(recording, context())));
    std::mt19937 random(3);
    std::normal_distribution<double> noise;
    auto& x = samples(recording, "axlebox_2");
    const double level = rms(x);
    for (double& value : x) value = level * noise(random);
    EXPECT_TRUE(unchecked(inspect(recording, context())));
}

TEST(Faults, OffsetOfATenthOfTheRms) {
    Recording recording = sound();
    auto& x = samples(recording, "axlebox_4");
    const double offset = 0.1 * rms(x);
    for (double& v : x) v += offset;
    const auto faults = found(recording, FaultKind::offset);
    ASSERT_NO_FATAL_FAILURE(expect_only(faults, "axlebox_4"));
    EXPECT_NEAR(faults[0].value, offset, 0.1 * offset);
}

TEST(Faults, DriftOfHalfTheRms) {
    Recording recording = sound();
    auto& x = samples(recording, "bogie_2");
    const double drift = 0.5 * rms(x);
    for (std::size_t n = 0; n < x.size(); ++n) x[n] += drift * static_cast<double>(n) / static_cast<double>(x.size());
    const auto faults = found(recording, FaultKind::drift);
    ASSERT_NO_FATAL_FAILURE(expect_only(faults, "bogie_2"));
    EXPECT_NEAR(faults[0].value, drift, 0.1 * drift);
}

TEST(Faults, LowFrequencyNoise) {
    Recording recording = make_record({.duration_s = 60.0, .sampling_rate_hz = 500.0, .seed = 5});
    auto& x = samples(recording, "axlebox_2");
    // A random walk of a twentieth of the channel's rms: f^-2.
    std::mt19937_64 generator(4);
    std::normal_distribution<double> normal;
    std::vector<double> walk(x.size());
    double value = 0.0;
    for (double& w : walk) w = value += normal(generator);
    walk = without_trend(walk);
    const double scale = 0.05 * rms(x) / rms(walk);
    for (std::size_t n = 0; n < x.size(); ++n) x[n] += scale * walk[n];
    const auto faults = found(recording, FaultKind::low_frequency_noise);
    ASSERT_NO_FATAL_FAILURE(expect_only(faults, "axlebox_2"));
    EXPECT_GT(faults[0].value, 1.0);
}

TEST(Faults, DuplicatedWithGain) {
    Recording recording = sound();
    auto& x = samples(recording, "axlebox_2");
    const auto& other = samples(recording, "axlebox_1");
    std::mt19937_64 generator(5);
    std::normal_distribution<double> normal(0.0, 0.002 * rms(other));
    for (std::size_t n = 0; n < x.size(); ++n) x[n] = 1.02 * other[n] + normal(generator);
    ASSERT_NO_FATAL_FAILURE(expect_only(found(recording, FaultKind::duplicated), "axlebox_1"));
}

}  // namespace
}  // namespace railpem::recordings::testing
