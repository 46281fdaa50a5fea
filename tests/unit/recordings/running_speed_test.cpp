// The speed as a function of time, read from channels that meet the same track.

#include "recordings/estimates/running_speed.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

namespace railpem::recordings {
namespace {

/// A rough line: waves of random phase from 0.15 to 4 m, an equal power in each.
class Line {
  public:
    explicit Line(unsigned seed) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> phase(0.0, 2.0 * std::numbers::pi);
        for (int i = 0; i < 1500; ++i) {
            waves_.push_back(2.0 * std::numbers::pi * (0.25 + 6.4 * i / 1500.0));
            phases_.push_back(phase(random));
        }
    }
    double at(double place_m) const {
        double sum = 0.0;
        for (std::size_t i = 0; i < waves_.size(); ++i) sum += std::cos(waves_[i] * place_m + phases_[i]);
        return sum;
    }

  private:
    std::vector<double> waves_, phases_;
};

constexpr VehicleGeometry kGeometry{.wheels_m = {10.2, 7.8, -7.8, -10.2}, .bogies_m = {9.0, -9.0}};

/// What wheels 1 and 4 meet along the line on a path, with noise.
TimeSeries met(const TrackPath& path, double seconds, double noise) {
    const Line line(5);
    constexpr double kRate = 500.0;
    TimeSeries series{.sampling_rate_hz = kRate};
    std::mt19937 random(9);
    std::normal_distribution<double> normal(0.0, noise);
    for (const int wheel : {1, 4}) {
        Channel channel;
        channel.description.location = Location::wheel;
        channel.description.index = wheel;
        const double place = kGeometry.wheels_m[static_cast<std::size_t>(wheel - 1)];
        for (std::size_t i = 0; i < static_cast<std::size_t>(seconds * kRate); ++i)
            channel.samples.push_back(line.at(path.distance_at(static_cast<double>(i) / kRate) + place) +
                                      normal(random));
        series.channels.push_back(std::move(channel));
    }
    return series;
}

TrackPath path_of(const std::function<double(double)>& speed, double seconds) {
    std::vector<double> time, speeds;
    for (double t = 0.0; t <= seconds; t += 0.25) time.push_back(t), speeds.push_back(speed(t));
    return track_path(time, speeds, 0.25, seconds);
}

/// Largest relative error away from the ends, where no window reaches.
double worst(const TrackPath& found, const TrackPath& truth, double seconds) {
    double most = 0.0;
    for (double t = 4.0; t < seconds - 4.0; t += 0.25)
        most = std::max(most, std::abs(found.speed_at(t) / truth.speed_at(t) - 1.0));
    return most;
}

TEST(TrackPath, TimeIsTheInverseOfDistance) {
    const TrackPath path = path_of([](double t) { return 12.0 + 3.0 * std::sin(0.3 * t); }, 20.0);
    for (double t = -2.0; t < 25.0; t += 0.7) EXPECT_NEAR(path.time_at(path.distance_at(t)), t, 1e-9);
    EXPECT_NEAR(path.mean_m_per_s(), path.distance_at(20.0) / 20.0, 1e-12);
}

TEST(RunningSpeed, AConstantSpeedIsConstant) {
    const TrackPath truth = path_of([](double) { return 22.0; }, 30.0);
    const std::optional<RunningSpeed> found = running_speed(met(truth, 30.0, 1.0), kGeometry, 22.1);
    ASSERT_TRUE(found);
    // A twentieth of the first look's step of 0.4 %: what eight refinements leave of it.
    EXPECT_LT(worst(found->path, truth, 30.0), 2e-4);
    EXPECT_GT(found->agreement, 0.9);
}

TEST(RunningSpeed, AWanderingSpeedIsFollowed) {
    const auto speed = [](double t) { return 22.0 * (1.0 + 0.012 * std::sin(2.0 * std::numbers::pi * t / 9.0)); };
    const TrackPath truth = path_of(speed, 30.0);
    const std::optional<RunningSpeed> found = running_speed(met(truth, 30.0, 1.0), kGeometry, 22.0);
    ASSERT_TRUE(found);
    EXPECT_LT(worst(found->path, truth, 30.0), 4e-4);  // a thirtieth of the swing: windows of 4 s in a period of 9 s
}

TEST(RunningSpeed, ATrainThatSpeedsUpIsFollowed) {
    const TrackPath truth = path_of([](double t) { return 14.0 + 0.3 * t; }, 40.0);
    const std::optional<RunningSpeed> found = running_speed(met(truth, 40.0, 1.0), kGeometry, 20.0);
    ASSERT_TRUE(found);
    EXPECT_LT(worst(found->path, truth, 40.0), 1e-3);
}

TEST(RunningSpeed, NoPairOrNoLengthSaysNothing) {
    const TrackPath truth = path_of([](double) { return 22.0; }, 30.0);
    TimeSeries one = met(truth, 20.0, 1.0);
    EXPECT_FALSE(running_speed(met(truth, 10.0, 1.0), kGeometry, 22.0));
    one.channels.pop_back();
    EXPECT_FALSE(running_speed(one, kGeometry, 22.0));
}

TEST(RunningSpeed, ChannelsThatShareNothingDoNotAgree) {
    const TrackPath truth = path_of([](double) { return 22.0; }, 30.0);
    const std::optional<RunningSpeed> found = running_speed(met(truth, 30.0, 3000.0), kGeometry, 22.0);
    ASSERT_TRUE(found);
    EXPECT_LT(found->agreement, 0.3);  // by chance the best of a few hundred speeds explains a tenth to a fifth
}

}  // namespace
}  // namespace railpem::recordings
