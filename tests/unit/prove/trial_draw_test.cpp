// Trials are drawn from seed and number alone, within the ranges that are promised.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "app/prove/effect_draws.hpp"
#include "tests/unit/prove/proof_case.hpp"

namespace railpem::app {
namespace {

constexpr std::size_t kTrials = 200;

const ProofCase& proof() {
    static const ProofCase own;
    return own;
}

const std::vector<TrialTruth>& drawn() {
    static const std::vector<TrialTruth> all = [] {
        std::vector<TrialTruth> list;
        for (std::size_t trial = 0; trial < kTrials; ++trial) list.push_back(proof().draw(11, trial));
        return list;
    }();
    return all;
}

TEST(TrialDraw, SameSeedAndNumberGiveTheSameBitsInAnyOrder) {
    for (const std::size_t trial : {37u, 5u, 12u})
        EXPECT_EQ(trial_truth_text(proof().draw(11, trial)), trial_truth_text(drawn()[trial]));
}

TEST(TrialDraw, AnotherSeedGivesOtherTrials) {
    EXPECT_NE(trial_truth_text(proof().draw(12, 3)), trial_truth_text(drawn()[3]));
}

// The world is not drawn: everything else of a trial is the same in any of them.
TEST(TrialDraw, AnotherWorldChangesNothingElse) {
    const World good = read_world_option("good");
    const TrialTruth ideal = proof().draw(11, 5);
    TrialTruth imperfect = draw_trial(proof().file, proof().believed, {.seed = 11, .world = good}, 5);
    EXPECT_EQ(imperfect.world.parameters, good.parameters);
    EXPECT_EQ(imperfect.noise_rms_m_per_s2, 0.0) << "the world has noise of its own";
    EXPECT_NE(trial_truth_text(imperfect).find("\"grade\": \"good\""), std::string::npos);
    EXPECT_EQ(trial_truth_text(ideal).find("grade"), std::string::npos);
    imperfect.world = {};
    imperfect.noise_rms_m_per_s2 = ideal.noise_rms_m_per_s2;
    EXPECT_EQ(trial_truth_text(imperfect), trial_truth_text(ideal));
}

TEST(TrialDraw, AnyBeginningHoldsTheMix) {
    const TrialMix mix;
    for (const std::size_t count : {40u, 100u, 200u}) {
        std::array<double, 6> kinds{};
        for (std::size_t i = 0; i < count; ++i) kinds[static_cast<std::size_t>(drawn()[i].kind)] += 1.0;
        // Multiples of the golden section are spread more evenly than any others (Kuipers & Niederreiter 1974,
        // section 2.3): a kind is off by two at most here, where independent draws of 200 trials would leave the
        // singles off by 7 (one standard deviation).
        for (std::size_t kind = 0; kind < kinds.size(); ++kind)
            EXPECT_NEAR(kinds[kind], mix.shares[kind] * static_cast<double>(count), 2.0) << kind;
    }
}

TEST(TrialDraw, EveryEffectTakesItsTurn) {
    std::set<std::string> singles;
    for (const TrialTruth& truth : drawn())
        if (truth.kind == TrialKind::single) singles.insert(truth.hidden.front().id);
    const std::vector<std::string> all = drawable_effects(proof().file, TrialKind::single);
    EXPECT_EQ(singles, std::set<std::string>(all.begin(), all.end()));
    EXPECT_EQ(singles.count("sleeper-flexibility"), 0u) << "the paper's track has no sleepers";
    EXPECT_EQ(singles.size() + 6u, diagnosis::effects().size())
        << "all but sleepers, four sensor faults and parameter errors";
}

TEST(TrialDraw, NumbersAreOffWithinTheirTolerances) {
    double largest = 0.0;
    for (const TrialTruth& truth : drawn()) {
        ASSERT_EQ(truth.numbers.size(), proof().believed.uncertain.size());
        EXPECT_LE(std::abs(truth.level_db), 1.0);
        if (truth.kind == TrialKind::parameter_error || truth.kind == TrialKind::pair) continue;
        for (std::size_t i = 0; i < truth.numbers.size(); ++i) {
            const diagnosis::BelievedNumber& believed = proof().believed.uncertain[i];
            const double off = (truth.numbers[i].truth / truth.numbers[i].believed - 1.0) / believed.tolerance;
            EXPECT_LE(std::abs(off), 1.0 + 1e-9) << believed.key;
            largest = std::max(largest, std::abs(off));
        }
    }
    EXPECT_GT(largest, 0.95) << "the whole tolerance is used";
}

TEST(TrialDraw, ParameterErrorsAreBeyondTolerance) {
    std::size_t greater = 0, all = 0;
    for (const TrialTruth& truth : drawn()) {
        if (truth.kind != TrialKind::parameter_error) continue;
        const double factor = truth.hidden.front().values.numbers.at("factor");
        EXPECT_TRUE((factor >= 1.4 && factor <= 2.5) || (factor >= 0.4 && factor <= 1.0 / 1.4)) << factor;
        greater += factor > 1.0;
        ++all;
        const std::string key = truth.hidden.front().values.texts.at("parameter");
        const auto number =
            std::find_if(truth.numbers.begin(), truth.numbers.end(), [&](const TrueNumber& n) { return n.key == key; });
        ASSERT_NE(number, truth.numbers.end());
        EXPECT_NEAR(true_value(truth, "parameter-error", key, "factor"), number->truth / number->believed, 1e-12);
        EXPECT_NEAR(number->truth / number->believed / factor, 1.0, 0.31) << "the tolerance comes on top";
    }
    EXPECT_GT(all, 8u);
    EXPECT_GT(greater, 0u);
    EXPECT_LT(greater, all);
}

TEST(TrialDraw, SpeedsAreApartAndStatedWithinTheirTolerance) {
    std::set<std::size_t> counts;
    for (const TrialTruth& truth : drawn()) {
        counts.insert(truth.records.size());
        for (const TrialRecord& record : truth.records) {
            EXPECT_GE(record.speed_m_per_s, 12.0);
            EXPECT_LE(record.speed_m_per_s, 40.0);
            EXPECT_NEAR(record.stated_speed_m_per_s / record.speed_m_per_s, 1.0, 0.005);
            for (const TrialRecord& other : truth.records)
                EXPECT_TRUE(&other == &record ||
                            std::abs(std::log(other.speed_m_per_s / record.speed_m_per_s)) >= std::log(1.15));
        }
    }
    EXPECT_EQ(counts, (std::set<std::size_t>{1, 2, 3}));
}

TEST(TrialDraw, ValuesLieWithinTheRangesOfSimulatorAndCatalogue) {
    for (const TrialTruth& truth : drawn())
        for (const simulate::Hidden& hidden : truth.hidden) {
            EXPECT_FALSE(hidden.forced) << hidden.id;
            const diagnosis::Effect* effect = diagnosis::find_effect(hidden.id);
            EXPECT_EQ(effect == nullptr, truth.kind == TrialKind::outside) << hidden.id;
            if (!effect) continue;
            for (const diagnosis::EffectParameter& parameter : effect->parameters) {
                const auto value = hidden.values.numbers.find(parameter.name);
                // A fraction of zero means that every n-th seat has failed instead.
                if (value == hidden.values.numbers.end() || (parameter.name == "fraction" && value->second == 0.0))
                    continue;
                EXPECT_GE(value->second, parameter.low) << hidden.id << " " << parameter.name;
                EXPECT_LE(value->second, parameter.high) << hidden.id << " " << parameter.name;
            }
        }
}

TEST(TrialDraw, PlacesAreThoseOfTheCatalogue) {
    for (const TrialTruth& truth : drawn())
        for (const simulate::Hidden& hidden : truth.hidden) {
            const diagnosis::Effect* effect = diagnosis::find_effect(hidden.id);
            if (!effect || hidden.id == "parameter-error") continue;
            const std::vector<std::string> places = true_places(truth);
            EXPECT_TRUE(std::any_of(effect->elements.begin(), effect->elements.end(), [&](diagnosis::Element element) {
                return std::find(places.begin(), places.end(), element_name(element)) != places.end();
            })) << hidden.id;
        }
}

TEST(EffectDraws, StrengthsAreParametersThatAreDrawn) {
    for (const std::vector<EffectDraw>* draws : {&physics_draws(), &sensor_draws(), &outside_draws()})
        for (const EffectDraw& draw : *draws) {
            if (draw.strength.empty()) continue;
            EXPECT_TRUE(std::any_of(draw.parameters.begin(), draw.parameters.end(), [&](const DrawnParameter& p) {
                return p.name == draw.strength;
            })) << draw.id;
        }
}

}  // namespace
}  // namespace railpem::app
