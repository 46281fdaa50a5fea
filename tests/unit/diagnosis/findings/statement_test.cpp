// What a diagnosis says in words, of figures that are given.

#include "diagnosis/findings/statement.hpp"

#include <gtest/gtest.h>

namespace railpem::diagnosis {
namespace {

TEST(Statement, ConsistentSaysWhichNumberHadToGoFar) {
    Diagnosis diagnosis{.verdict = Verdict::consistent};
    diagnosis.retuned_numbers = {{.key = "vehicle.body_mass_kg", .tolerances_away = -0.5},
                                 {.key = "vehicle.bogie_mass_kg", .tolerances_away = 1.2}};
    EXPECT_NE(statement_of(diagnosis).find("retuned within their tolerances the case"), std::string::npos);
    diagnosis.retuned_numbers.front() = {.key = "vehicle.body_mass_kg", .tolerances_away = -2.6, .outside = true};
    EXPECT_NE(statement_of(diagnosis).find("retuned (the furthest, vehicle.body_mass_kg, by 2.6 tolerances) the case"),
              std::string::npos);
}

// A wrong number is nothing that a case left out, and retuning has found it.
TEST(Statement, ANumberIsNothingThatWasLeftOut) {
    Diagnosis diagnosis{.verdict = Verdict::explained};
    diagnosis.omitted = {
        {.instance = {.effect = "parameter-error", .values = {}, .choices = {{"parameter", "vehicle.bogie_mass_kg"}}},
         .says = "nothing is missing: a value is wrong"}};
    EXPECT_TRUE(
        statement_of(diagnosis).starts_with("Nothing is missing: a value is wrong (parameter vehicle.bogie_mass_kg). "
                                            "With it the recordings are more probable than after retuning alone by"));
    diagnosis.omitted.front() = {.instance = {.effect = "rail-shear", .values = {}, .choices = {}},
                                 .says = "the rail shears"};
    EXPECT_TRUE(statement_of(diagnosis).starts_with("What the case left out: the rail shears"));
}

TEST(Statement, WhatOnlyGivesUpABeliefIsHeldAgainstWhoKeepsIt) {
    Diagnosis diagnosis{.verdict = Verdict::explained};
    diagnosis.omitted = {{.instance = {.effect = "irregularity-spectrum", .values = {}, .choices = {}},
                          .says = "the track is smoother"}};
    diagnosis.retuned = {2.86, -349.8}, diagnosis.after = {0.42, -318.5};
    diagnosis.held_out_retuned = {3.1, -19.5}, diagnosis.held_out_after = {0.94, 11.5};
    diagnosis.freely_retuned = FreelyRetuned{.fitted = {0.42, -318.6}, .held_out = {0.93, 11.6}};
    EXPECT_EQ(
        statement_of(diagnosis),
        "What the case left out: the track is smoother (). With it the recordings are more probable than after "
        "retuning that keeps what is given up within two tolerances by 31.3 nats per second of record, "
        "and what no fit has seen by 31. Retuning that may leave the belief for what that costs goes there, too.");
}

// Every n-th fastener has no share of seats: a dead band of the pads that acted like ten of them beyond their range
// ended the program.
TEST(Statement, ValuesAreThoseThatAreStated) {
    EXPECT_EQ(values_in_words({.effect = "failed-fasteners",
                               .values = {{"remaining_stiffness_fraction", -0.21}},
                               .choices = {{"every", "10"}}}),
              "remaining_stiffness_fraction -0.21, every 10");
    EXPECT_EQ(values_in_words({.effect = "contact-nonlinearity", .values = {{"factor", 6.5}}, .choices = {}}),
              "factor 6.5");
}

TEST(Statement, AmbiguousNamesBothAndWhatWouldDecide) {
    Diagnosis diagnosis;
    diagnosis.verdict = Verdict::ambiguous;
    diagnosis.rivals = {{.effects = {"rail-damper"}, .probability = 0.62, .would_separate = "a run at 33 m/s"},
                        {.effects = {"rail-shear", "sensor-gain"}, .probability = 0.38}};
    EXPECT_EQ(statement_of(diagnosis),
              "Something is missing, and these cannot be told apart with what was recorded: rail-damper (62 %), or "
              "rail-shear with sensor-gain (38 %). "
              "What would decide: a run at 33 m/s.");
}

TEST(Statement, UnexplainedSaysWhereNoCorrectionReaches) {
    Diagnosis diagnosis;
    diagnosis.verdict = Verdict::unexplained;
    diagnosis.places = {{.element = Element::support, .probability = 0.5},
                        {.element = Element::wheel, .nats = 300.0},
                        {.element = Element::pad, .probability = 0.5, .nats = 11000.0}};
    EXPECT_EQ(statement_of(diagnosis),
              "Something is missing that no known effect explains: as far as it has a name it sits at the support, and "
              "the place where a free correction helps most is the pad (11000 nats).");
}

TEST(Statement, UnexplainedSaysWhereACorrectionPromisesMoreThanAtItsPlace) {
    Diagnosis diagnosis;
    diagnosis.verdict = Verdict::unexplained;
    diagnosis.places = {{.element = Element::wheel, .probability = 1.0, .nats = 2920.0},
                        {.element = Element::pad, .nats = 46659.0}};
    EXPECT_EQ(statement_of(diagnosis),
              "Something is missing that no known effect explains: the most probable place is the wheel (2920 nats); "
              "to the retuned case a free correction of the pad promises more (46659 nats).");
}

TEST(Statement, AmbiguousWithoutANameSaysSo) {
    Diagnosis diagnosis;
    diagnosis.verdict = Verdict::ambiguous;
    diagnosis.rivals = {{.effects = {"suspension-friction"}, .probability = 0.8, .would_separate = "a run at 33 m/s"},
                        {.effects = {"unknown"}, .probability = 0.2}};
    EXPECT_EQ(statement_of(diagnosis),
              "Something is missing, and these cannot be told apart with what was recorded: suspension-friction (80 "
              "%), or something there without a name (20 %). "
              "What would decide: a run at 33 m/s.");
}

TEST(Statement, UnexplainedNamesThePlace) {
    Diagnosis diagnosis;
    diagnosis.verdict = Verdict::unexplained;
    EXPECT_EQ(statement_of(diagnosis), "Something is missing that no known effect explains: no place stands out.");
    diagnosis.places = {{.element = Element::rail, .probability = 0.97, .nats = 14.2},
                        {.element = Element::pad, .probability = 0.03, .nats = 6.0}};
    EXPECT_EQ(statement_of(diagnosis),
              "Something is missing that no known effect explains: the place where a free correction helps most is the "
              "rail (14 nats).");
    diagnosis.places.front() = {.element = Element::secondary, .nats = 90.0, .forces = true};
    EXPECT_NE(statement_of(diagnosis).find("secondary (90 nats, by forces of its own, as of a stop"),
              std::string::npos);
    diagnosis.places.front() = {.element = Element::support, .nats = 90.0, .forces = true, .resonance_hz = 39.4};
    EXPECT_NE(statement_of(diagnosis).find(
                  "support (90 nats, by what each wheel meets by itself, which resonates near 39 Hz"),
              std::string::npos);
}

}  // namespace
}  // namespace railpem::diagnosis
