// Distances that share lines with a fitted one.

#include "diagnosis/comb_relatives.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace railpem::diagnosis {
namespace {

EffectInstance joints(double spacing) {
    return {.effect = "rail-joints", .values = {{"spacing_m", spacing}, {"depth_m", 1e-3}, {"length_m", 0.8}}, .choices = {}};
}

bool has_spacing(const std::vector<EffectInstance>& relatives, double spacing) {
    return std::any_of(relatives.begin(), relatives.end(), [&](const EffectInstance& own) { return std::abs(own.values.at("spacing_m") - spacing) < 1e-9; });
}

TEST(CombRelatives, TheTrueDistanceIsAmongThoseOfFourTimesIt) { EXPECT_TRUE(has_spacing(comb_relatives(joints(50.0)), 12.5)); }

TEST(CombRelatives, TheTrueDistanceIsAmongThoseOfHalfOfIt) { EXPECT_TRUE(has_spacing(comb_relatives(joints(12.5)), 25.0)); }

TEST(CombRelatives, StayWithinTheRangeAndKeepTheLinesThatBothHave) {
    const std::vector<EffectInstance> relatives = comb_relatives(joints(12.0));
    EXPECT_FALSE(has_spacing(relatives, 4.0)) << "below 5 m";
    for (const EffectInstance& own : relatives) {
        // The line of a dip is its Fourier coefficient: depth over distance times what the length alone decides.
        EXPECT_NEAR(own.values.at("depth_m") / own.values.at("spacing_m"), 1e-3 / 12.0, 1e-12);
        EXPECT_EQ(own.values.at("length_m"), 0.8);
    }
}

TEST(CombRelatives, WhatHasNoCombHasNone) {
    EXPECT_TRUE(comb_relatives({.effect = "body-bending", .values = {{"frequency_hz", 9.0}}, .choices = {}}).empty());
}

}  // namespace
}  // namespace railpem::diagnosis
