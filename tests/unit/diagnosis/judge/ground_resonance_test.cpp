// What differs from wheel to wheel at the pads is of the ground where it resonates.

#include "diagnosis/judge/ground_resonance.hpp"

#include <gtest/gtest.h>

#include "diagnosis/judge/posterior.hpp"

namespace railpem::diagnosis {
namespace {

const std::vector<double> kOctaves = {2.0, 4.2, 8.9, 18.7, 39.4, 83.1, 175.0};

std::optional<double> resonance(std::vector<double> share) {
    return resonance_of({.frequency_hz = kOctaves, .share = std::move(share)});
}

// Fitted to marched records of ground that wanders about 31 Hz and 77 Hz.
TEST(GroundResonance, IsSeenWhereTheGroundWanders) {
    EXPECT_EQ(resonance({3e-5, 1e-5, 0.0, 0.00127, 0.00603, 0.0, 4e-5}), 39.4);
    EXPECT_EQ(resonance({0.0, 0.0, 0.0, 0.0, 0.00025, 0.00259, 0.0}), 83.1);
}

// Fitted to marched records of a play of 0.1 mm, on two vehicles' runs; that of the second is as strong in the last two
// nodes.
TEST(GroundResonance, IsNotSeenOfAPlay) {
    EXPECT_FALSE(resonance({2e-5, 0.0, 0.0, 0.00037, 0.00033, 0.00152, 0.00311}));
    EXPECT_FALSE(resonance({0.0, 0.0, 8e-5, 0.00055, 0.00044, 0.0033, 0.00324}));
}

TEST(GroundResonance, MayLieBetweenTwoNodes) {
    EXPECT_EQ(resonance({0.0, 0.0, 1e-4, 0.005, 0.006, 1e-4, 0.0}), 39.4);
    EXPECT_FALSE(resonance({0.0, 0.0, 0.004, 0.005, 0.006, 0.004, 0.0})) << "four nodes are broad";
    EXPECT_FALSE(resonance({0.0, 0.0, 1e-4, 0.005, 0.006, 0.005, 1e-4})) << "so are three";
}

TEST(GroundResonance, IsNotAtAnEndNorOfNothing) {
    EXPECT_FALSE(resonance({0.006, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}));
    EXPECT_FALSE(resonance({0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.006}));
    EXPECT_FALSE(resonance({0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}));
    EXPECT_FALSE(resonance_of({}));
}

PlaceStudy study_of(std::vector<double> share) {
    FittedSet pads;
    pads.anonymous = {{.element = Element::pad, .channel = {}, .forces = true}};
    pads.fit.trial.numbers.modifiers.wheels_own = {.frequency_hz = kOctaves, .share = std::move(share)};
    PlaceStudy study;
    study.anonymous = {pads};
    study.at_retuned = {{.element = Element::pad, .nats = 500.0, .forces = true},
                        {.element = Element::wheel, .nats = 40.0},
                        {.element = Element::support, .nats = 30.0}};
    return study;
}

TEST(GroundResonance, MovesWhatHasNoNameToTheGround) {
    PlaceStudy study = study_of({0.0, 0.0, 0.0, 1e-4, 0.006, 1e-4, 0.0});
    tell_ground_from_pads(study);
    EXPECT_EQ(study.anonymous.front().anonymous.front().element, Element::support);
    ASSERT_EQ(study.at_retuned.size(), 3u);
    EXPECT_EQ(study.at_retuned[0].element, Element::pad);
    EXPECT_EQ(study.at_retuned[1].element, Element::support);
    EXPECT_EQ(study.at_retuned[1].nats, 500.0);
    EXPECT_EQ(study.at_retuned[1].resonance_hz, 39.4);
    const Decision decision{.verdict = Verdict::unexplained, .unknown_score = 1000.0};
    const std::vector<PlaceEvidence> places = place_probabilities({}, study, decision);
    EXPECT_EQ(places.front().element, Element::support);
    EXPECT_EQ(places.front().resonance_hz, 39.4);
}

TEST(GroundResonance, LeavesAPlayAtThePads) {
    PlaceStudy study = study_of({0.0, 0.0, 0.0, 0.0004, 0.0003, 0.0015, 0.003});
    tell_ground_from_pads(study);
    EXPECT_EQ(study.anonymous.front().anonymous.front().element, Element::pad);
    EXPECT_EQ(study.at_retuned.size(), 3u);
    EXPECT_EQ(study.at_retuned.back().nats, 30.0);
}

// A factor on the stiffness of the pads says nothing of masses below them.
TEST(GroundResonance, DoesNotMoveAFactor) {
    PlaceStudy study = study_of({0.0, 0.0, 0.0, 1e-4, 0.006, 1e-4, 0.0});
    study.anonymous.front().anonymous.front().forces = false;
    tell_ground_from_pads(study);
    EXPECT_EQ(study.anonymous.front().anonymous.front().element, Element::pad);
}

}  // namespace
}  // namespace railpem::diagnosis
