// Channels whose unit cannot be trusted, two rails in one recording, a speed that only a channel states.

#include "diagnosis/observations/channel_scales.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "diagnosis/fit/derivatives.hpp"
#include "diagnosis/fit/fit.hpp"
#include "diagnosis/observations/rail_sides.hpp"
#include "recordings/stated_speed.hpp"
#include "tests/unit/diagnosis/synthesised_fixture.hpp"

namespace railpem::diagnosis {
namespace {

constexpr double kLogPower = 3.0;  ///< of the wheel's scale: 13 dB

/// Bogie and wheel, of which the wheel reads too high by a factor that nobody states.
Synthesised with_a_scale() {
    Synthesised made =
        synthesised(paper_believed({"vehicle.bogie_mass_kg"}), {20.0}, 60.0, {"bogie_1", "wheel_1"}, kSmall);
    made.shapes[0].unknown_scale[1] = true;
    made.truth.log_gain[0] = {0.0, kLogPower};
    made.draw(5);
    return made;
}

// Before, the scale of a time series was taken for known: the level went into irregularity and noise.
TEST(ChannelScales, AreFoundBesideTheNumbers) {
    Synthesised made = with_a_scale();
    const std::vector<Unknown> unknowns = nuisance_unknowns(made.believed, made.observations);
    const Fit found = fit(believed_trial(made.believed, made.observations), unknowns, means(unknowns), made.context());
    bool seen = false;
    for (std::size_t u = 0; u < unknowns.size(); ++u) {
        if (unknowns[u].kind != UnknownKind::gain) continue;
        seen = true;
        // four deviations: once in 16 000 draws
        EXPECT_NEAR(found.values[u], kLogPower, 4.0 * found.deviation(u)) << unknowns[u].name;
        EXPECT_LT(found.deviation(u), 0.1) << unknowns[u].name;  // the bogie beside it, whose scale is known, fixes it
    }
    EXPECT_TRUE(seen);
}

TEST(ChannelScales, GuessIsTheMeanDifferenceOfTheLevels) {
    Synthesised made = with_a_scale();
    Observation& observation = made.observations[0];
    guess_scales(observation, made.believed.numbers);
    ASSERT_EQ(observation.log_scale.size(), 2u);
    EXPECT_EQ(observation.log_scale[0], 0.0);
    // the mean of log Ŝ lies below log S, 0.02 at 30 averages; the irregularity's chance
    EXPECT_NEAR(observation.log_scale[1], kLogPower, 0.3);
}

// The irregularity's derivatives are taken from one solution: they must know of the scale, too.
TEST(ChannelScales, DerivativesOfTheIrregularityKnowThem) {
    Synthesised made = with_a_scale();
    std::vector<Unknown> unknowns = nuisance_unknowns(made.believed, made.observations);
    std::erase_if(unknowns, [](const Unknown& own) { return own.kind != UnknownKind::irregularity; });
    const std::vector<double> values = means(unknowns);
    const auto derivatives_at = [&](double gain) {
        Trial trial = believed_trial(made.believed, made.observations);
        trial.log_gain[0] = {0.0, gain};
        set_values(trial, unknowns, values);
        return differentiate(trial, unknowns, values, predict(trial, made.context()), made.context());
    };
    const std::vector<PredictionDerivative> without = derivatives_at(0.0), with = derivatives_at(kLogPower);
    ASSERT_EQ(without.size(), with.size());
    const double wheel = std::exp(kLogPower), cross = std::exp(0.5 * kLogPower);
    const double factors[] = {1.0, cross, cross, wheel};
    for (std::size_t d = 0; d < with.size(); ++d)
        for (std::size_t i = 0; i < with[d].values.size(); ++i)
            EXPECT_NEAR(std::abs(with[d].values[i] - factors[i % 4] * without[d].values[i]), 0.0,
                        1e-9 * std::abs(with[d].values[i]) + 1e-30);
}

recordings::Channel axle_box(const std::string& name, recordings::Side side) {
    return {.description = {.name = name, .location = recordings::Location::wheel, .index = 1, .side = side},
            .samples = {1.0, 2.0}};
}

TEST(RailSides, EachBecomesARecordingOfItsOwn) {
    recordings::Recording recording;
    recording.series.channels = {axle_box("left", recordings::Side::left), axle_box("right", recordings::Side::right),
                                 axle_box("frame", recordings::Side::unstated)};
    recording.series.channels[2].description.location = recordings::Location::bogie;
    const std::vector<SideRecording> sides = one_rail_each(recording);
    ASSERT_EQ(sides.size(), 2u);
    EXPECT_EQ(sides[0].suffix, "_left");
    ASSERT_EQ(sides[0].recording.series.channels.size(), 2u);
    EXPECT_EQ(sides[0].recording.series.channels[1].description.name, "frame");
    ASSERT_EQ(sides[1].recording.series.channels.size(), 1u);
    EXPECT_EQ(sides[1].recording.series.channels[0].description.name, "right");
}

TEST(RailSides, ChannelsOfOneSideStayTogether) {
    recordings::Recording recording;
    recording.series.channels = {axle_box("first", recordings::Side::left),
                                 axle_box("second", recordings::Side::right)};
    recording.series.channels[1].description.index = 2;
    const std::vector<SideRecording> sides = one_rail_each(recording);
    ASSERT_EQ(sides.size(), 1u);
    EXPECT_EQ(sides[0].suffix, "");
}

TEST(StatedSpeed, IsThatOfTheChannelWhereTheDescriptionHasNone) {
    recordings::Recording recording;
    recording.series.speed_m_per_s = {18.0, 19.0, 20.0, 19.0};
    const recordings::StatedSpeed of_channel = recordings::stated_speed(recording);
    EXPECT_DOUBLE_EQ(of_channel.m_per_s, 19.0);
    EXPECT_NEAR(of_channel.standard_error, std::sqrt(0.5), 1e-12);
    recording.description.speed_m_per_s = 25.0;
    recording.description.speed_standard_error_m_per_s = 0.1;
    EXPECT_DOUBLE_EQ(recordings::stated_speed(recording).m_per_s, 25.0);
    EXPECT_DOUBLE_EQ(recordings::stated_speed(recording).standard_error, 0.1);
}

}  // namespace
}  // namespace railpem::diagnosis
