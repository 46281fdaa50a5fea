#include "diagnosis/hypotheses/worth_refitting.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace railpem::diagnosis {
namespace {

Candidate candidate(const std::string& effect, std::map<std::string, std::string> choices) {
    const EffectInstance instance{.effect = effect, .values = {}, .choices = std::move(choices)};
    return {.instance = instance, .probe = instance};
}

Promise promise(std::size_t candidate, double gain) {
    return {.candidate = candidate, .gain = gain, .strength = 1.0, .move = {}};
}

std::vector<std::string> labels(const std::vector<Starts>& chosen, const std::vector<Candidate>& candidates) {
    std::vector<std::string> all;
    for (const Starts& starts : chosen) all.push_back(label_of(candidates[starts.front().candidate].instance));
    return all;
}

// Two of a kind; fasteners that fail at random are another kind than every n-th, whose many numbers would leave them no
// turn.
TEST(WorthRefitting, TwoOfEveryKind) {
    const std::vector<Candidate> candidates = {candidate("failed-fasteners", {{"every", "20"}}),
                                               candidate("failed-fasteners", {{"every", "16"}}),
                                               candidate("failed-fasteners", {{"every", "8"}}),
                                               candidate("failed-fasteners", {}), candidate("wheelset-bending", {})};
    const std::vector<Promise> promises = {promise(0, 100.0), promise(1, 90.0), promise(2, 80.0), promise(3, 70.0),
                                           promise(4, 60.0)};
    const std::vector<std::string> expected = {"failed-fasteners (every 20)", "failed-fasteners (every 16)",
                                               "failed-fasteners", "wheelset-bending"};
    EXPECT_EQ(labels(worth_refitting(promises, candidates, 5.0, 8), candidates), expected);
}

TEST(WorthRefitting, NoMoreThanAskedAndNothingFaint) {
    const std::vector<Candidate> candidates = {candidate("failed-fasteners", {}), candidate("wheelset-bending", {}),
                                               candidate("rail-damper", {})};
    const std::vector<Promise> promises = {promise(0, 1000.0), promise(1, 900.0), promise(2, 6.0)};
    EXPECT_EQ(worth_refitting(promises, candidates, 5.0, 8).size(), 2U) << "a hundredth of the best promise waits";
    EXPECT_EQ(worth_refitting(promises, candidates, 5.0, 1).size(), 1U);
    EXPECT_TRUE(worth_refitting(promises, candidates, 2000.0, 8).empty());
}

// Retuning moves sleeper passing and the spectrum already, against what is believed of them: what is left of a promise
// there is what the belief costs.
TEST(WorthRefitting, WhatOnlyGivesUpABeliefNeedsLess) {
    const std::vector<Candidate> candidates = {candidate("rail-damper", {}), candidate("sleeper-passing", {}),
                                               candidate("irregularity-spectrum", {})};
    const std::vector<Promise> promises = {promise(0, 3.5), promise(1, 1.6), promise(2, 1.4)};
    EXPECT_EQ(labels(worth_refitting(promises, candidates, 7.0, 8), candidates),
              std::vector<std::string>{"sleeper-passing"});
}

// 190 nats of 3.3 promised: what has to bring 3400 beside a law that is an approximation is not asked where it
// promises 10.
TEST(WorthRefitting, ABeliefThatCannotBringEnoughIsKept) {
    const std::vector<Candidate> candidates = {candidate("sleeper-passing", {})};
    EXPECT_TRUE(worth_refitting({promise(0, 10.0)}, candidates, 3400.0, 8).empty());
    EXPECT_EQ(worth_refitting({promise(0, 57.0)}, candidates, 3400.0, 8).size(), 1U);
}

// Grid points of one variant are starts of one fit.
TEST(WorthRefitting, GridPointsOfAVariantGoTogether) {
    std::vector<Candidate> candidates(5, candidate("rail-damper", {}));
    std::vector<Promise> promises;
    for (std::size_t i = 0; i < candidates.size(); ++i) promises.push_back(promise(i, 100.0 - static_cast<double>(i)));
    const std::vector<Starts> chosen = worth_refitting(promises, candidates, 5.0, 8);
    ASSERT_EQ(chosen.size(), 1U);
    EXPECT_EQ(chosen.front().size(), 3U);
}

// Joints every 12 m began 3 nats behind those every 25 m, and were never climbed.
TEST(WorthRefitting, DistancesOfACombAreClimbedApart) {
    const std::vector<Candidate> candidates = {candidate("rail-joints", {}), candidate("rail-joints", {}),
                                               candidate("rail-joints", {}), candidate("rail-damper", {})};
    const auto apart = climbed_apart({promise(0, 13.0), promise(1, 8.0), promise(2, 7.5)}, candidates);
    ASSERT_EQ(apart.size(), 2U);
    EXPECT_EQ(apart[1].front().candidate, 1U);
    EXPECT_EQ(climbed_apart({promise(3, 9.0), promise(3, 8.0)}, candidates).size(), 1U)
        << "grid points of anything else compete";
}

// A rail that shears looks like one that bends more easily: the number was released, and the law never tried.
TEST(WorthRefitting, ANumberWorthReleasingSpeaksForTheLawOfItsPlace) {
    const std::vector<Candidate> candidates = {candidate("rail-shear", {}), candidate("pad-hysteresis", {})};
    const std::vector<Promise> promises = {promise(0, 1.0), promise(1, 1.0)};
    std::vector<Starts> chosen;
    add_replacing(promises, candidates, {}, chosen);
    EXPECT_TRUE(chosen.empty());
    add_replacing(promises, candidates, {"track.rail.second_moment_of_area_m4"}, chosen);
    EXPECT_EQ(labels(chosen, candidates), std::vector<std::string>{"rail-shear"});
}

// Half a bin beside a sharp peak the first order asks for a hundredth of it.
TEST(WorthRefitting, WhatWasReadOffStartsThere) {
    std::vector<Candidate> candidates = {candidate("sensor-resonance", {{"channel", "bogie_1"}})};
    candidates[0].whole = true;
    std::vector<Promise> promises = {promise(0, 100.0)};
    promises[0].strength = 0.01;
    EXPECT_TRUE(worth_refitting(promises, candidates, 5.0, 8).empty());
    candidates[0].read_off = true;
    EXPECT_EQ(worth_refitting(promises, candidates, 5.0, 8).size(), 1U);
}

}  // namespace
}  // namespace railpem::diagnosis
