// Rivals of sets whose evidences are given.

#include "diagnosis/findings/rivals.hpp"

#include <gtest/gtest.h>

namespace railpem::diagnosis {
namespace {

FittedSet friction_beside_a_gain() {
    const EffectInstance friction{
        .effect = "suspension-friction", .values = {{"force_n", 900.0}}, .choices = {{"stage", "primary"}}};
    const EffectInstance gain{.effect = "sensor-gain", .values = {{"gain", 1.1}}, .choices = {{"channel", "bogie_1"}}};
    FittedSet set;
    set.effects = {{.instance = friction}, {.instance = gain}};
    set.fit.trial.effects = {friction, gain};
    set.fit.log_evidence = 1000.0;
    return set;
}

std::vector<Rival> rivals_where(const FrictionLaw& law) {
    NamingResult naming;
    naming.sets = {friction_beside_a_gain()};
    PlaceStudy study;
    study.friction = law;
    const VerdictThresholds thresholds;
    const Decision decision = decide(naming, study, thresholds);
    const BelievedCase believed;
    const std::vector<Observation> observations;
    const LikelihoodContext context{.believed = &believed, .observations = &observations};
    return rivals_of({.believed = believed,
                      .observations = observations,
                      .context = context,
                      .thresholds = thresholds,
                      .naming = naming,
                      .study = study,
                      .decision = decision,
                      .retuned = naming.retuned,
                      .named = naming.sets.front()});
}

TEST(Rivals, SayWhatTheyGainOnTheUnseen) {
    NamingResult naming;
    naming.retuned.held_out = -5.0;
    naming.sets = {friction_beside_a_gain(), friction_beside_a_gain()};
    naming.sets[0].held_out = 300.0, naming.sets[1].held_out = 20.0, naming.sets[1].fit.log_evidence = 100.0;
    PlaceStudy study;
    study.belief_kept = FittedSet{.held_out = -900.0};  // of another question
    const VerdictThresholds thresholds;
    const Decision decision = decide(naming, study, thresholds);
    const BelievedCase believed;
    const std::vector<Observation> observations;
    const LikelihoodContext context{.believed = &believed, .observations = &observations};
    const std::vector<Rival> rivals = rivals_of({.believed = believed,
                                                 .observations = observations,
                                                 .context = context,
                                                 .thresholds = thresholds,
                                                 .naming = naming,
                                                 .study = study,
                                                 .decision = decision,
                                                 .retuned = naming.retuned,
                                                 .named = naming.sets.front()});
    ASSERT_EQ(rivals.size(), 1u);
    EXPECT_EQ(rivals.front().nats_behind, 900.0);
    EXPECT_EQ(rivals.front().nats_held_out, 25.0);
}

TEST(Rivals, AreNoneBesideAFrictionThatIsConstant) {
    EXPECT_TRUE(rivals_where({1.1, 0.015, 1.1}).empty());
}

TEST(Rivals, OfAFrictionThatMayBeAnotherAreBothLaws) {
    const std::vector<Rival> rivals = rivals_where({1.1, 0.3, 1.1});
    ASSERT_EQ(rivals.size(), 2u);
    EXPECT_EQ(rivals[0].effects, (std::vector<std::string>{"suspension-friction", "sensor-gain"}));
    EXPECT_EQ(rivals[1].effects, (std::vector<std::string>{"unknown", "sensor-gain"}));
    EXPECT_NEAR(rivals[1].probability, probability_of_another({1.1, 0.3, 1.1}), 1e-12);
    EXPECT_NEAR(rivals[0].probability + rivals[1].probability, 1.0, 1e-12);
    ASSERT_EQ(rivals[1].instances.size(), 2u);
    EXPECT_EQ(rivals[1].instances[0].effect, "unknown");
    EXPECT_EQ(rivals[1].instances[0].choices.at("stage"), "primary");
    EXPECT_TRUE(rivals[1].instances[0].values.empty()) << "its force is not known by the law of another";
    EXPECT_EQ(rivals[1].instances[1].effect, "sensor-gain");
    for (const Rival& rival : rivals)
        EXPECT_EQ(rival.would_separate, "a test of the damper alone")
            << "there is no recording here that another could stand beside";
}

}  // namespace
}  // namespace railpem::diagnosis
