// Distances that share lines with a fitted one.

#include "diagnosis/hypotheses/proposers/comb_relatives.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace railpem::diagnosis {
namespace {

EffectInstance joints(double spacing) {
    return {.effect = "rail-joints",
            .values = {{"spacing_m", spacing}, {"depth_m", 1e-3}, {"length_m", 0.8}},
            .choices = {}};
}

bool has_spacing(const std::vector<EffectInstance>& relatives, double spacing) {
    return std::any_of(relatives.begin(), relatives.end(), [&](const EffectInstance& own) {
        return std::abs(own.values.at("spacing_m") - spacing) < 1e-9;
    });
}

TEST(CombRelatives, TheTrueDistanceIsAmongThoseOfFourTimesIt) {
    EXPECT_TRUE(has_spacing(comb_relatives(joints(50.0)), 12.5));
}

TEST(CombRelatives, TheTrueDistanceIsAmongThoseOfHalfOfIt) {
    EXPECT_TRUE(has_spacing(comb_relatives(joints(12.5)), 25.0));
}

TEST(CombRelatives, StayWithinTheRangeAndKeepTheLinesThatBothHave) {
    const std::vector<EffectInstance> relatives = comb_relatives(joints(12.0));
    EXPECT_FALSE(has_spacing(relatives, 4.0)) << "below 5 m";
    for (const EffectInstance& own : relatives) {
        // The line of a dip is its Fourier coefficient: depth over distance times what the length alone decides.
        EXPECT_NEAR(own.values.at("depth_m") / own.values.at("spacing_m"), 1e-3 / 12.0, 1e-12);
        EXPECT_EQ(own.values.at("length_m"), 0.8);
    }
}

TEST(CombRelatives, StopWhereNoWindowTellsTheLinesApart) {
    EXPECT_TRUE(has_spacing(comb_relatives(joints(30.0)), 60.0));
    EXPECT_FALSE(has_spacing(comb_relatives(joints(30.0), 50.0), 60.0));
}

// Windows of 4 s have bins of 0.25 Hz: at 15 m/s lines of 40 m are one and a half bins apart.
TEST(CombRelatives, TheSlowestRunHasToTellTheLinesApart) {
    Observation slow{.speed_m_per_s = 15.0}, fast{.speed_m_per_s = 30.0};
    slow.kernel = fast.kernel = {.window = recordings::Window::hann, .length = 4000, .sampling_rate_hz = 1000.0};
    EXPECT_NEAR(longest_comb_m({slow, fast}), 40.0, 1e-12);
}

TEST(CombRelatives, WhatHasNoCombHasNone) {
    EXPECT_TRUE(comb_relatives({.effect = "body-bending", .values = {{"frequency_hz", 9.0}}, .choices = {}}).empty());
}

// 1.037: from the fourteenth line on more than half of their distance aside.
TEST(CombRelatives, DecoysHaveTheirLinesBetweenThoseOfTheComb) {
    const std::vector<EffectInstance> decoys = comb_decoys(joints(30.0));
    ASSERT_EQ(decoys.size(), 2U);
    for (const EffectInstance& decoy : decoys) {
        const double line = 14.0 * 30.0 / decoy.values.at("spacing_m");  // in lines of the comb
        EXPECT_NEAR(std::abs(line - std::round(line)), 0.5, 0.02);
        EXPECT_EQ(decoy.values.at("depth_m"), joints(30.0).values.at("depth_m"));
    }
    EXPECT_TRUE(comb_decoys({.effect = "body-bending", .values = {{"frequency_hz", 9.0}}, .choices = {}}).empty());
}

}  // namespace
}  // namespace railpem::diagnosis
