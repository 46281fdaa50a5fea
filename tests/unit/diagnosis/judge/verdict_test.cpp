// Decisions over sets whose evidences are given.

#include "diagnosis/judge/verdict.hpp"

#include <gtest/gtest.h>

#include <tuple>

#include "tests/unit/diagnosis/given_sets.hpp"

namespace railpem::diagnosis {
namespace {

TEST(Decide, NamesWhatGains) {
    const NamingResult naming = given_naming({given_set({"rail-shear"}, {}, 100.0, 10.0)});
    EXPECT_EQ(decide(naming, {}, thresholds).verdict, Verdict::explained);
}

TEST(Decide, SaysNothingIsMissingBelowTheLeastGain) {
    EXPECT_EQ(decide(given_naming({given_set({"rail-shear"}, {}, 4.9, 10.0)}), {}, thresholds).verdict,
              Verdict::consistent);
    EXPECT_EQ(decide(given_naming({given_set({"rail-shear"}, {}, 100.0, -0.1)}), {}, thresholds).verdict,
              Verdict::consistent);
    EXPECT_EQ(decide(given_naming({given_set({}, {"vehicle.body_mass_kg"}, 100.0, -1.0)}), {}, thresholds).verdict,
              Verdict::explained);
}

// A number 3.7 tolerances off has 1.5 nats with its prior, which of fourteen by chance one is in 300 cases; physics
// that nobody believed in has to bring more.
TEST(Decide, NamesABeliefThatIsFurtherOffThanChance) {
    EXPECT_EQ(decide(given_naming({given_set({}, {"vehicle.body_mass_kg"}, 1.6, 0.0)}), {}, thresholds).verdict,
              Verdict::explained);
    EXPECT_EQ(decide(given_naming({given_set({}, {"vehicle.body_mass_kg"}, 1.4, 0.0)}), {}, thresholds).verdict,
              Verdict::consistent);
    EXPECT_EQ(decide(given_naming({given_set({"sleeper-passing"}, {}, 1.6, 0.0)}), {}, thresholds).verdict,
              Verdict::explained);
    EXPECT_EQ(decide(given_naming({given_set({"rail-shear"}, {}, 1.6, 0.0)}), {}, thresholds).verdict,
              Verdict::consistent);
    EXPECT_EQ(
        decide(given_naming({given_set({"rail-shear"}, {"vehicle.body_mass_kg"}, 4.9, 0.0)}), {}, thresholds).verdict,
        Verdict::consistent);
}

// Both numbers may be it; an effect that explains less than its own freedom costs may not.
TEST(Decide, LeavesOnlyThatTogetherWhichExplainsSomething) {
    const auto verdict_beside = [](const FittedSet& other) {
        return decide(given_naming({given_set({}, {"vehicle.body_mass_kg"}, 2.5, 0.0), other}), {}, thresholds).verdict;
    };
    EXPECT_EQ(verdict_beside(given_set({}, {"vehicle.bogie_mass_kg"}, 1.6, 0.0)), Verdict::ambiguous);
    EXPECT_EQ(verdict_beside(given_set({"rail-shear"}, {}, 2.0, 0.0)), Verdict::ambiguous);
    EXPECT_EQ(verdict_beside(given_set({"rail-shear"}, {}, -1.0, 0.0)), Verdict::explained);
}

TEST(Decide, DoesNotNamePhysicsBeyondItsRange) {
    EXPECT_EQ(
        decide(given_naming({leaning_set(given_set({"body-bending"}, {}, 100.0, 10.0), 3.0)}), {}, thresholds).verdict,
        Verdict::unexplained);
    EXPECT_EQ(
        decide(given_naming({leaning_set(given_set({"body-bending"}, {}, 100.0, 10.0), 1.0)}), {}, thresholds).verdict,
        Verdict::explained);
}

// Fasteners that carry nothing lie on the end of their range, and what their mean receptance leaves drives them beyond:
// up to 3 % of what they explain. A law that is exact has no such excuse.
TEST(Decide, ForgivesAnApproximationAtTheEndOfItsRange) {
    const auto fasteners = [](double nats) {
        FittedSet set = leaning_set(given_set({"failed-fasteners"}, {}, 1000.0, 100.0), nats);
        set.fit.unknowns.front().name = "failed-fasteners.remaining_stiffness_fraction";
        return set;
    };
    EXPECT_EQ(decide(given_naming({fasteners(25.0)}), {}, thresholds).verdict, Verdict::explained);
    EXPECT_EQ(decide(given_naming({fasteners(35.0)}), {}, thresholds).verdict, Verdict::unexplained);
    FittedSet exact = leaning_set(given_set({"body-bending"}, {}, 1000.0, 100.0), 25.0);
    EXPECT_EQ(decide(given_naming({exact}), {}, thresholds).verdict, Verdict::unexplained);
}

// An unknown that outdoes the best set takes its name, unless both together say more than the unknown alone.
TEST(Decide, NamesBesideAnUnknownOnlyWhatStandsBesideIt) {
    const NamingResult naming = given_naming({given_set({"rail-shear"}, {}, 100.0, 10.0)});
    for (const bool stands : {true, false}) {
        PlaceStudy study{.named_stands = stands};
        study.anonymous = {given_set({}, {}, 150.0, 10.0)};
        const Decision decision = decide(naming, study, thresholds);
        EXPECT_EQ(decision.verdict, Verdict::unexplained);
        EXPECT_EQ(decision.named != nullptr, stands);
        study.anonymous = {given_set({}, {}, 102.0, 10.0)};  // not outdone
        EXPECT_NE(decide(naming, study, thresholds).named, nullptr);
    }
}

TEST(Decide, LeavesEqualsTogether) {
    const NamingResult naming =
        given_naming({given_set({"rail-shear"}, {}, 100.0, 10.0), given_set({"body-bending"}, {}, 97.0, 10.0),
                      given_set({"body-bending"}, {}, 95.0, 10.0)});
    const Decision decision = decide(naming, {}, thresholds);
    EXPECT_EQ(decision.verdict, Verdict::ambiguous);
    EXPECT_EQ(decision.credible.size(), 2u);
}

TEST(Decide, WithholdsTheNameWhereMoreIsLeftThanChance) {
    const NamingResult naming = given_naming({given_set({"rail-shear"}, {}, 100.0, 10.0)});
    PlaceStudy places;
    places.at_named = {{.element = Element::bogie, .nats = 13.0}};
    EXPECT_EQ(decide(naming, places, thresholds).verdict, Verdict::unexplained);
    const NamingResult large = given_naming({given_set({"rail-shear"}, {}, 10000.0, 10.0)});
    EXPECT_EQ(decide(large, places, thresholds).verdict, Verdict::explained) << "a thousandth of what it explains";
}

TEST(Decide, WithholdsTheNameWhereTheUnseenRepeatsMisfit) {
    const NamingResult naming = given_naming({given_set({"wheelset-bending"}, {}, 1000.0, 100.0)}),
                       linearised = given_naming({given_set({"suspension-friction"}, {}, 1000.0, 100.0)});
    EXPECT_EQ(decide(naming, {.by_named = 11.0}, thresholds).verdict, Verdict::explained);
    EXPECT_EQ(decide(naming, {.by_named = 13.0}, thresholds).verdict, Verdict::unexplained);
    EXPECT_EQ(decide(linearised, {.by_named = 240.0}, thresholds).verdict, Verdict::explained);
    EXPECT_EQ(decide(linearised, {.by_named = 260.0}, thresholds).verdict, Verdict::unexplained);
    EXPECT_EQ(decide(given_naming({}), {.by_retuned = 13.0}, thresholds).verdict, Verdict::unexplained);
    EXPECT_EQ(decide(given_naming({}), {.by_retuned = 11.0}, thresholds).verdict, Verdict::consistent);
}

// A third of the record is unseen: of 60 nats 20 are expected there, with a deviation of 6. A marched null had 59
// and 4.5. Physics is the same at every speed: what only imitates it has another strength in each recording.
TEST(Decide, WithholdsTheNameWhereRecordingsDisagreeAboutIt) {
    for (const auto& [effect, nats, verdict] :
         {std::tuple("body-bending", 11.0, Verdict::explained), std::tuple("body-bending", 13.0, Verdict::unexplained),
          // 3 % of a law that is an approximation
          std::tuple("rail-damper", 29.0, Verdict::explained), std::tuple("rail-damper", 31.0, Verdict::unexplained)}) {
        PlaceStudy study;
        study.by_recording = {{.observation = {0, 1}, .value = {0.35, 0.4}, .nats = nats}};
        EXPECT_EQ(decide(given_naming({given_set({effect}, {}, 1000.0, 300.0)}), study, thresholds).verdict, verdict)
            << effect << nats;
    }
}

// The forces that friction has beside its damping have the power of a constant force's, more of it, or nobody knows.
TEST(Decide, AsksWhetherFrictionIsConstant) {
    const NamingResult naming = given_naming({given_set({"suspension-friction"}, {}, 1000.0, 300.0)});
    for (const auto& [power, deviation, verdict] :
         {std::tuple(1.15, 0.02, Verdict::explained), std::tuple(1.5, 0.05, Verdict::unexplained),
          std::tuple(1.5, 0.2, Verdict::ambiguous), std::tuple(1.2, 0.3, Verdict::ambiguous)}) {
        PlaceStudy study;
        study.friction = FrictionLaw{power, deviation, 1.2};
        const Decision decision = decide(naming, study, thresholds);
        EXPECT_EQ(decision.verdict, verdict) << power;
        EXPECT_EQ(decision.other_friction > 0.0, verdict == Verdict::ambiguous) << power;
        EXPECT_NE(decision.named, nullptr) << "it sits there, whatever its law";
    }
}

TEST(Decide, NamesNothingThatTheUnseenDoesNotRepeat) {
    const auto verdict_of = [](double gain, double repeated, const char* effect = "rail-shear") {
        NamingResult naming = given_naming({given_set({effect}, {}, 50.0, repeated)});
        naming.sets.front().fit.log_likelihood = gain;
        naming.unseen_share = 1.0 / 3.0;
        return decide(naming, {}, thresholds).verdict;
    };
    EXPECT_EQ(verdict_of(60.0, 4.5), Verdict::consistent);
    EXPECT_EQ(verdict_of(60.0, 12.0), Verdict::explained);
    EXPECT_EQ(verdict_of(12.0, 0.5), Verdict::explained) << "within chance";
    EXPECT_EQ(verdict_of(12000.0, 2000.0), Verdict::explained) << "an approximate law repeats half of what it promised";
    EXPECT_EQ(verdict_of(12000.0, 1000.0), Verdict::consistent);
    EXPECT_EQ(verdict_of(70.0, 5.2), Verdict::consistent);
    EXPECT_EQ(verdict_of(70.0, 5.2, "sleeper-passing"), Verdict::explained)
        << "a belief: no place or distance was sought that chance could have offered";
    EXPECT_EQ(verdict_of(70.0, 2.0, "sleeper-passing"), Verdict::consistent);
}

/// A set whose fit ends a number so many tolerances away from its belief.
FittedSet bent(FittedSet set, double tolerances, double deviation = 0.05) {
    set.fit.unknowns = {
        {.kind = UnknownKind::number, .name = "vehicle.bogie_mass_kg", .mean = 0.0, .deviation = deviation}};
    set.fit.values = {tolerances * 0.05};
    return set;
}

// A play of the fastenings was explained by a nonlinear contact whose constant was 5.3 tolerances off. What failed
// fasteners leave bends numbers: 10.8 beside right ones, 12.9 and more beside three plays that they had a part in
// explaining.
TEST(Decide, NamesNothingThatNeedsWrongNumbers) {
    const auto verdict_of = [](const char* effect, double tolerances) {
        return decide(given_naming({bent(given_set({effect}, {}, 1000.0, 300.0), tolerances)}), {}, thresholds).verdict;
    };
    for (const auto& [effect, right, wrong] :
         {std::tuple("rail-shear", 3.9, 5.3), std::tuple("contact-nonlinearity", 3.9, 5.3),
          std::tuple("failed-fasteners", 10.8, 12.9)})
        for (const double sign : {-1.0, 1.0}) {
            EXPECT_EQ(verdict_of(effect, sign * right), Verdict::explained) << effect;
            EXPECT_EQ(verdict_of(effect, sign * wrong), Verdict::unexplained) << effect;
        }
}

// Preload on the end of its range, with numbers that were far off, stood beside a play of the fastenings that explained
// more.
TEST(Decide, NamesNothingBesideAnUnknownThatCannotBe) {
    const auto named = [](const FittedSet& set) {
        PlaceStudy study{.named_stands = true};
        study.anonymous = {given_set({}, {}, 1150.0, 300.0)};
        return decide(given_naming({set}), study, thresholds).named != nullptr;
    };
    const FittedSet right = given_set({"rail-shear"}, {}, 1000.0, 300.0);
    EXPECT_TRUE(named(right));
    EXPECT_FALSE(named(bent(right, 5.3)));
    EXPECT_FALSE(named(leaning_set(given_set({"body-bending"}, {}, 1000.0, 300.0), 25.0)));
}

// A decibel beyond chance is what a case that explains may leave; fasteners in the place of a play left 1.6 and more.
// Friction is linearised about a level, and right with 3.6 dB.
TEST(Decide, NamesNothingThatLeavesLevelsOff) {
    const auto verdict_of = [](const char* effect, double level_db) {
        return decide(given_naming({given_set({effect}, {}, 1000.0, 300.0)}), {.named_level_db = level_db}, thresholds)
            .verdict;
    };
    EXPECT_EQ(verdict_of("rail-shear", 0.9), Verdict::explained);
    EXPECT_EQ(verdict_of("rail-shear", 1.6), Verdict::unexplained);
    EXPECT_EQ(verdict_of("failed-fasteners", 1.6), Verdict::unexplained);
    EXPECT_EQ(verdict_of("suspension-friction", 3.6), Verdict::explained);
}

TEST(Decide, IsNotConsistentWhereLevelsAreOff) {
    const auto verdict_of = [](double level_db) {
        return decide(given_naming({}), {.retuned_level_db = level_db}, thresholds).verdict;
    };
    EXPECT_EQ(verdict_of(0.9), Verdict::consistent);
    EXPECT_EQ(verdict_of(1.1), Verdict::unexplained);
}

// A number that is named as wrong may be as wrong as it is.
TEST(Decide, NamesANumberHoweverWrong) {
    const FittedSet released = bent(given_set({}, {"vehicle.bogie_mass_kg"}, 1000.0, 300.0), 12.9, kReleasedDeviation);
    EXPECT_EQ(decide(given_naming({released}), {}, thresholds).verdict, Verdict::explained);
}

// Contact nine times as soft as believed was named between two kilometres of one run.
TEST(Decide, NamesNoNumberThatWouldHaveToBeFurtherOffThanAWrongOneIs) {
    const FittedSet number = given_set({}, {"contact.constant_m_per_n23"}, 1000.0, 300.0);
    const Decision beyond = decide(given_naming({leaning_number(number, 10.0)}), {}, thresholds);
    EXPECT_EQ(beyond.verdict, Verdict::unexplained);
    EXPECT_EQ(beyond.named, nullptr);
    EXPECT_EQ(number_beyond_range(leaning_number(number, 10.0)), "contact.constant_m_per_n23");
    // Chance may carry it as far.
    EXPECT_EQ(decide(given_naming({leaning_number(number, 1.0)}), {}, thresholds).verdict, Verdict::explained);
    // Of an effect it is the strength that leans.
    EXPECT_EQ(number_beyond_range(leaning_set(given_set({"rail-shear"}, {}, 1000.0, 300.0), 10.0)), "");
}

// What an approximation leaves may drive a parameter to the end of its range, but no strength beyond its top by more
// than its law gets wrong: 3 x 3.5 % of the contact's nonlinearity.
TEST(Decide, NamesNothingThatWouldBeStrongerThanItsPhysics) {
    ASSERT_EQ(find_effect("contact-nonlinearity")->parameters.front().inexact, 0.035);
    EXPECT_EQ(decide(given_naming({contact_beyond(1.2)}), {}, thresholds).verdict, Verdict::unexplained);
    EXPECT_EQ(decide(given_naming({contact_beyond(1.05)}), {}, thresholds).verdict, Verdict::explained);
}

// What distorts more than steel on steel can may be anywhere between wheel and ground: it has no place for it.
TEST(BeyondRange, IsNoContact) {
    const std::vector<Observation> none;
    const BelievedCase believed;
    const LikelihoodContext context{.believed = &believed, .observations = &none};
    EXPECT_FALSE(fit_beyond_range(believed, leaning_set(given_set({"contact-nonlinearity"}, {}, 100.0, 20.0), 50.0),
                                  context, {}));
}

// It is no effect that could be fitted beyond its range.
TEST(BeyondRange, IsNoNumber) {
    const std::vector<Observation> none;
    const BelievedCase believed;
    const LikelihoodContext context{.believed = &believed, .observations = &none};
    EXPECT_FALSE(fit_beyond_range(
        believed, leaning_number(given_set({"rail-shear"}, {"vehicle.bogie_mass_kg"}, 100.0, 20.0), 50.0), context,
        {}));
}

}  // namespace
}  // namespace railpem::diagnosis
