// Faults of sampling, time and running that concern a whole record.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "faulty_record.hpp"
#include "recordings/estimates/interpolation.hpp"

namespace railpem::recordings::testing {
namespace {

TEST(Faults, MainsHum) {
    Recording recording = sound();
    auto& x = samples(recording, "body_centre");
    for (std::size_t n = 0; n < x.size(); ++n)
        x[n] += 0.02 * std::sin(2.0 * std::numbers::pi * 50.01 * static_cast<double>(n) / 500.0 + 1.0);
    const auto faults = found(recording, FaultKind::mains_hum);
    ASSERT_NO_FATAL_FAILURE(expect_only(faults, "body_centre"));
    EXPECT_NEAR(faults[0].value, 0.02 / std::sqrt(2.0), 0.001);
    EXPECT_EQ(faults[0].severity, Severity::warning);
}

TEST(Faults, AliasingAfterDecimationWithoutAFilter) {
    const Recording fast = make_record({.duration_s = 40.0, .sampling_rate_hz = 1000.0, .seed = 8});
    Recording recording = fast;
    recording.series.sampling_rate_hz = 125.0;
    recording.description.sampling_rate_hz = 125.0;
    for (Channel& channel : recording.series.channels) {
        std::vector<double> every_eighth;
        for (std::size_t n = 0; n < channel.samples.size(); n += 8) every_eighth.push_back(channel.samples[n]);
        channel.samples = every_eighth;
    }
    const auto faults = found(recording, FaultKind::aliasing);
    ASSERT_GE(faults.size(), 4U);
    for (const char* name : {"axlebox_1", "axlebox_2", "axlebox_3", "axlebox_4"})
        EXPECT_TRUE(std::any_of(faults.begin(), faults.end(), [&](const Fault& f) { return f.channels[0] == name; }))
            << name;
}

std::vector<double> clock(const Recording& recording, double scatter_s, double digits) {
    std::mt19937_64 generator(6);
    std::normal_distribution<double> normal(0.0, scatter_s);
    std::vector<double> time;
    for (std::size_t n = 0; n < recording.series.size(); ++n) {
        const double t =
            static_cast<double>(n) / recording.series.sampling_rate_hz + (scatter_s > 0.0 ? normal(generator) : 0.0);
        time.push_back(digits > 0.0 ? digits * std::round(t / digits) : t);
    }
    return time;
}

TEST(Faults, SamplingJitter) {
    Recording recording = sound();
    recording.series.time_s = clock(recording, 0.0, 1e-3);
    EXPECT_TRUE(found(recording, FaultKind::sampling_jitter).empty());
    recording.series.time_s = clock(recording, 5e-5, 1e-6);
    const auto faults = found(recording, FaultKind::sampling_jitter);
    ASSERT_EQ(faults.size(), 1U);
    EXPECT_NEAR(faults[0].value, std::sqrt(2.0) * 5e-5, 5e-6);  // of an interval: two scattered ends
}

TEST(Faults, GapInTimeAndWrongRate) {
    Recording recording = sound();
    recording.series.time_s = clock(recording, 0.0, 1e-6);
    for (std::size_t n = 6000; n < recording.series.size(); ++n) recording.series.time_s[n] += 0.25;
    const auto gaps = found(recording, FaultKind::missing_samples);
    ASSERT_EQ(gaps.size(), 1U);
    EXPECT_NEAR(gaps[0].to_s - gaps[0].from_s, 0.252, 1e-6);
    recording.series.time_s = clock(recording, 0.0, 0.0);
    for (double& t : recording.series.time_s) t *= 1.001;
    const auto rate = found(recording, FaultKind::sampling_rate);
    ASSERT_EQ(rate.size(), 1U);
    EXPECT_NEAR(rate[0].value, 500.0 / 1.001, 1e-3);
}

TEST(Faults, TimingSkewIsToldFromTheWheelbaseDelay) {
    for (const auto& [name, skew] :
         {std::pair("axlebox_2", 0.003), std::pair("axlebox_3", -0.0015), std::pair("axlebox_4", 0.001)}) {
        Recording recording = sound();
        delay(samples(recording, name), skew, 500.0);
        const auto faults = found(recording, FaultKind::timing_skew);
        ASSERT_NO_FATAL_FAILURE(expect_only(faults, name));
        EXPECT_NEAR(faults[0].value, skew, 2e-4) << faults[0].says;
    }
    // Another speed is no skew.
    Recording faster = make_record({.duration_s = 24.0, .sampling_rate_hz = 500.0, .speed_m_per_s = 40.0, .seed = 9});
    faster.description.speed_m_per_s = 40.0;
    EXPECT_TRUE(found(faster, FaultKind::timing_skew).empty());
}

TEST(Faults, SkewBetweenTheSidesOfAnAxle) {
    Recording recording = sound();
    Channel other = recording.series.channels[0];
    recording.series.channels[0].description.side = Side::left;
    other.description.side = Side::right;
    other.description.name = "axlebox_1_right";
    delay(other.samples, 0.002, 500.0);
    recording.series.channels.push_back(other);
    const auto faults = found(recording, FaultKind::timing_skew);
    ASSERT_FALSE(faults.empty());
    EXPECT_TRUE(std::any_of(faults.begin(), faults.end(), [](const Fault& f) {
        return f.channels[0] == "axlebox_1_right" && std::abs(f.value - 0.002) < 2e-4;
    }));
}

TEST(Faults, LevelThatChangesAlongTheRecord) {
    Recording recording = sound();
    auto& x = samples(recording, "axlebox_1");
    for (std::size_t n = x.size() / 2; n < x.size(); ++n) x[n] *= 2.0;
    const auto faults = found(recording, FaultKind::not_stationary);
    ASSERT_NO_FATAL_FAILURE(expect_only(faults, "axlebox_1"));
    EXPECT_NEAR(faults[0].value, 6.0, 2.5);
}

TEST(Faults, SpeedThatChanges) {
    // 20 m/s, then 21 m/s.
    const Recording slow =
        make_record({.duration_s = 24.0, .sampling_rate_hz = 500.0, .speed_m_per_s = 20.0, .seed = 12});
    const Recording fast =
        make_record({.duration_s = 24.0, .sampling_rate_hz = 500.0, .speed_m_per_s = 21.0, .seed = 13});
    Recording recording = slow;
    for (std::size_t i = 0; i < 9; ++i)
        recording.series.channels[i].samples.insert(recording.series.channels[i].samples.end(),
                                                    fast.series.channels[i].samples.begin(),
                                                    fast.series.channels[i].samples.end());
    const auto faults = found(recording, FaultKind::speed_changes);
    ASSERT_EQ(faults.size(), 1U);
    EXPECT_NEAR(faults[0].value, 0.05, 0.015);
}

TEST(Faults, ASpeedInAnotherUnitIsNamedWhereverItIsStated) {
    Recording recording = sound();
    recording.description.speed_m_per_s = 3.6 * settings().speed_m_per_s;
    auto faults = found(recording, FaultKind::speed_mismatch);
    ASSERT_EQ(faults.size(), 1U);
    EXPECT_NE(faults[0].says.find("km/h taken for m/s"), std::string::npos) << faults[0].says;
    recording.description.speed_m_per_s = 0.0;
    recording.series.speed_m_per_s.assign(recording.series.size(), 3.6 * settings().speed_m_per_s);
    faults = found(recording, FaultKind::speed_mismatch);
    ASSERT_EQ(faults.size(), 1U);
    EXPECT_EQ(faults[0].severity, Severity::error);
}

TEST(Faults, AClockThatRunsFasterIsToldInPartsPerMillion) {
    constexpr double kDrift = 200e-6;
    Recording recording = make_record({.duration_s = 48.0, .sampling_rate_hz = 500.0, .seed = 21});
    auto& x = samples(recording, "axlebox_3");
    const std::vector<double> before = x;
    for (std::size_t n = 0; n < x.size(); ++n) x[n] = sample_at(before, static_cast<double>(n) * (1.0 - kDrift));
    const InspectionReport report = inspect(recording, context());
    ASSERT_EQ(report.faults.size(), 1U) << report.faults[1].says;
    EXPECT_EQ(report.faults[0].kind, FaultKind::clock_drift) << report.faults[0].says;
    EXPECT_EQ(report.faults[0].channels, std::vector<std::string>{"axlebox_3"});
    EXPECT_NEAR(report.faults[0].value, 1e6 * kDrift, 10.0);
}

TEST(Faults, SpeedOtherThanStated) {
    Recording recording = sound();
    recording.description.speed_m_per_s *= 1.02;
    const auto faults = found(recording, FaultKind::speed_mismatch);
    ASSERT_EQ(faults.size(), 1U);
    EXPECT_NEAR(faults[0].value, settings().speed_m_per_s - recording.description.speed_m_per_s, 0.05);
}

TEST(Faults, Stop) {
    Recording recording = sound();
    std::mt19937_64 generator(7);
    std::normal_distribution<double> normal(0.0, 0.02);
    for (Channel& channel : recording.series.channels)
        for (std::size_t n = 5000; n < 8000; ++n) channel.samples[n] = normal(generator);
    const auto faults = found(recording, FaultKind::stop);
    ASSERT_EQ(faults.size(), 1U);
    EXPECT_NEAR(faults[0].from_s, 10.0, 0.51);
    EXPECT_NEAR(faults[0].to_s, 16.0, 0.51);
    EXPECT_EQ(inspect(recording, context()).faults.size(), 1U);  // and nothing else is blamed
}

TEST(Faults, Impacts) {
    Recording recording = sound();
    auto& x = samples(recording, "axlebox_1");
    const double size = 6.0 * rms(x);
    for (const std::size_t at : {3000U, 6000U, 9000U})  // 6 ms half sine: a joint
        for (std::size_t n = 0; n < 3; ++n)
            x[at + n] += size * std::sin(std::numbers::pi * (static_cast<double>(n) + 0.5) / 3.0);
    const auto faults = found(recording, FaultKind::impacts);
    ASSERT_NO_FATAL_FAILURE(expect_only(faults, "axlebox_1"));
    EXPECT_EQ(faults[0].value, 3.0);
}

TEST(Faults, MileageThatIsShort) {
    Recording recording = sound();
    for (std::size_t n = 0; n < recording.series.size(); ++n)
        recording.series.mileage_m.push_back(2000.0 + 0.96 * settings().speed_m_per_s * static_cast<double>(n) / 500.0);
    const auto faults = found(recording, FaultKind::mileage);
    ASSERT_EQ(faults.size(), 2U);  // one constant step, and 4 % short
    EXPECT_NEAR(faults[0].value, -0.04, 0.002);
}

TEST(Faults, TooShort) {
    Recording recording = make_record({.duration_s = 6.0, .sampling_rate_hz = 500.0, .seed = 3});
    EXPECT_EQ(found(recording, FaultKind::too_short).size(), 1U);
    for (Channel& channel : recording.series.channels) channel.samples.resize(20);
    EXPECT_EQ(found(recording, FaultKind::too_short).size(), 1U);
}

TEST(Faults, UnknownScaleIsSaid) {
    Recording recording = sound();
    recording.series.channels[1].description.scale = Scale::unknown;
    ASSERT_NO_FATAL_FAILURE(expect_only(found(recording, FaultKind::unknown_scale), "axlebox_2"));
}

}  // namespace
}  // namespace railpem::recordings::testing
