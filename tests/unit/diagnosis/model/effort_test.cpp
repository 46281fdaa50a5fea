// The count of what a search has computed, and searches that it ends.

#include "diagnosis/model/effort.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "diagnosis/search/name_physics.hpp"
#include "tests/unit/diagnosis/synthesised_fixture.hpp"

namespace railpem::diagnosis {
namespace {

Synthesised with_loud_sensors() {
    Synthesised made = synthesised(paper_believed({"vehicle.bogie_mass_kg"}), {15.0, 22.2}, 30.0,
                                   {"bogie_1", "bogie_2", "wheel_1", "wheel_3"}, kSmall);
    for (const char* channel : {"bogie_1", "axlebox_3"})
        made.truth.effects.push_back(
            {.effect = "sensor-gain", .values = {{"gain", 1.2}}, .choices = {{"channel", channel}}});
    made.draw(4);
    return made;
}

double effort_of_retuning(const Synthesised& made, int threads) {
    Effort effort;
    LikelihoodContext context = made.context(Part::fitted, threads);
    context.effort = &effort;
    const std::vector<Unknown> unknowns = nuisance_unknowns(made.believed, made.observations);
    fit(believed_trial(made.believed, made.observations), unknowns, means(unknowns), context);
    return effort.seconds();
}

TEST(Effort, IsTheSameWithAnyNumberOfThreads) {
    const Synthesised made = with_loud_sensors();
    const double one = effort_of_retuning(made, 1);
    EXPECT_GT(one, 0.0);
    EXPECT_EQ(one, effort_of_retuning(made, 2));
}

TEST(Effort, OfAPredictionIsLessTheMoreItReuses) {
    const pem::CaseParameters plain = tests::paper_case(1);
    EXPECT_GT(effort_of_prediction(plain, 1000, Reuse::nothing), effort_of_prediction(plain, 1000, Reuse::rail));
    EXPECT_GT(effort_of_prediction(plain, 1000, Reuse::rail), effort_of_prediction(plain, 1000, Reuse::transfers));
    pem::CaseParameters failed = plain;
    failed.track.failed_fasteners = {{.every = 8}};
    EXPECT_GT(effort_of_prediction(failed, 1000, Reuse::nothing), effort_of_prediction(plain, 1000, Reuse::nothing));
    EXPECT_EQ(effort_of_prediction(failed, 1000, Reuse::rail), effort_of_prediction(plain, 1000, Reuse::rail))
        << "the rail is not solved again";
}

// Recordings of a wide band, and many of them, are searched longer; how long their segments are does not matter.
TEST(Effort, IsAllowedByTheBandsOfTheRecordings) {
    const auto allowed = [](std::size_t count, double window_s) {
        const Synthesised made = synthesised(paper_believed({}), std::vector<double>(count, 22.2), 30.0, {"wheel_1"},
                                             {.window_s = window_s, .low_hz = 2.0, .high_hz = 162.0});
        return effort_allowed(made.shapes, 75.0);
    };
    EXPECT_DOUBLE_EQ(allowed(1, 1.0), 75.0);
    EXPECT_NEAR(allowed(6, 1.0), 150.0, 2.0);  // a bin more or less at the ends of a band of 160
    EXPECT_NEAR(allowed(6, 4.0), 150.0, 2.0);
}

NamingResult named(const Synthesised& made, double effort_s, int threads = 2) {
    return name_physics(made.believed, made.context(Part::fitted, threads), {.effort_s = effort_s});
}

bool was_ended(const NamingResult& found) {
    return std::any_of(found.not_tested.begin(), found.not_tested.end(),
                       [](const NotTested& own) { return own.effect == "further sets of effects"; });
}

TEST(Effort, EndsASearchWithWhatWasFound) {
    const Synthesised made = with_loud_sensors();
    const NamingResult whole = named(made, 75.0), ended = named(made, 1e-3);
    EXPECT_FALSE(was_ended(whole));
    EXPECT_TRUE(was_ended(ended));
    ASSERT_FALSE(ended.sets.empty());
    EXPECT_EQ(whole.sets.front().effects.size(), 2u);
    EXPECT_EQ(ended.sets.front().effects.size(), 1u);
    EXPECT_EQ(ended.sets.front().effects.front().instance.effect, "sensor-gain");
}

TEST(Effort, EndsASearchTheSameWithAnyNumberOfThreads) {
    const Synthesised made = with_loud_sensors();
    const NamingResult one = named(made, 1e-3, 1), two = named(made, 1e-3, 2);
    ASSERT_EQ(one.sets.size(), two.sets.size());
    for (std::size_t i = 0; i < one.sets.size(); ++i) EXPECT_EQ(one.sets[i].score(), two.sets[i].score());
}

}  // namespace
}  // namespace railpem::diagnosis
