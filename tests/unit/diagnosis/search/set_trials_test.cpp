// What the fits of the search make of a comb of lines.

#include "diagnosis/search/set_trials.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "diagnosis/hypotheses/screen.hpp"
#include "tests/unit/diagnosis/synthesised_fixture.hpp"

namespace railpem::diagnosis {
namespace {

/// The set that dips every `spacing_m` make when they are fitted to records of two speeds in which `hidden` is.
FittedSet fitted_dips(const EffectInstance& hidden, double spacing_m) {
    Synthesised made = synthesised(paper_believed({"vehicle.bogie_mass_kg"}), {15.0, 22.0}, 60.0,
                                   {"bogie_1", "wheel_1", "wheel_2"}, kFine);
    made.truth.effects = {hidden};
    made.draw(1);
    const LikelihoodContext context = made.context();
    const NamingOptions options;
    NamingResult result;
    SetTrials trials(made.believed, context, options, result);
    trials.retune();
    const CandidateList list = candidates(made.believed, result.retuned.fit.trial, made.observations);
    const auto joints = std::find_if(list.candidates.begin(), list.candidates.end(),
                                     [](const Candidate& own) { return own.instance.effect == "rail-joints"; });
    result.candidates = {*joints};
    for (EffectInstance* instance : {&result.candidates[0].instance, &result.candidates[0].probe})
        instance->values["spacing_m"] = spacing_m, instance->values["length_m"] = 0.3;
    const std::vector<Promise> promises = screen(result.retuned.fit, result.candidates, context);
    const FittedSet& best = trials.try_starts(result.retuned.fit, {promises.front()}, {}, {}, 0.0);
    std::printf("dips every %.1f m bring %.0f nats, score %.0f\n", spacing_m,
                best.fit.log_likelihood - result.retuned.fit.log_likelihood, best.score() - result.retuned.score());
    return best;
}

// A narrow band of roughness that the smooth irregularity does not take: lines every 0.62 and 0.91 Hz bring some 50
// nats, in whatever places they are.
TEST(SetTrials, ACombThatIsANoiseCannotBe) {
    for (const auto& [wavelength_m, bandwidth] : {std::pair{0.35, 0.03}, {0.6, 0.1}}) {
        const FittedSet dips =
            fitted_dips({.effect = "rail-corrugation",
                         .values = {{"wavelength_m", wavelength_m}, {"relative_bandwidth", bandwidth}, {"rms_m", 1e-3}},
                         .choices = {}},
                        24.3);
        EXPECT_TRUE(std::isfinite(dips.fit.log_evidence));
        EXPECT_TRUE(std::isinf(dips.score())) << wavelength_m;
    }
}

// 271 nats: lines where there should be none gain less than half of it.
TEST(SetTrials, ACombThatIsThereStays) {
    const FittedSet dips = fitted_dips(
        {.effect = "rail-joints", .values = {{"spacing_m", 24.3}, {"depth_m", 1e-3}, {"length_m", 0.5}}, .choices = {}},
        24.3);
    EXPECT_TRUE(std::isfinite(dips.score()));
}

EffectInstance gain_of(const std::string& channel, double gain) {
    return {.effect = "sensor-gain", .values = {{"gain", gain}}, .choices = {{"channel", channel}}};
}

/// Records with gains of two channels, and the fits of a search for them.
struct TwoGains {
    explicit TwoGains(double second_gain) {
        made.truth.effects = {gain_of("bogie_1", 1.2), gain_of("axlebox_1", second_gain)};
        made.draw(1);
        trials.retune();
        first = {.instance = made.truth.effects[0], .probe = made.truth.effects[0]};
        second = {.instance = made.truth.effects[1], .probe = made.truth.effects[1]};
    }

    Synthesised made =
        synthesised(paper_believed({"vehicle.bogie_mass_kg"}), {20.0}, 60.0, {"bogie_1", "wheel_1", "wheel_2"}, kSmall);
    const LikelihoodContext context = made.context();
    std::vector<std::string> said;
    NamingOptions options{.progress = [this](const std::string& what, double) { said.push_back(what); }};
    NamingResult result;
    SetTrials trials{made.believed, context, options, result};
    Candidate first, second;
};

/// The gains sought one after the other; what the search then tries without either of them, by name.
std::vector<std::string> tried_without(double known_is_worse_by) {
    TwoGains own(0.8);
    own.trials.try_set(own.result.retuned.fit, {own.first}, {}, 0.0);
    own.trials.try_set(own.result.retuned.fit, {own.first, own.second}, {}, 0.0);
    EXPECT_EQ(own.trials.leading().members(), 2u);
    EXPECT_TRUE(own.result.sets[0].fit.converged);
    own.result.sets[0].fit.log_posterior -= known_is_worse_by;
    own.said.clear();
    own.trials.prune();
    std::vector<std::string> tried;
    for (const Candidate& member : {own.first, own.second})
        if (std::find(own.said.begin(), own.said.end(), label_of(member.instance)) != own.said.end())
            tried.push_back(member.instance.choices.at("channel"));
    return tried;
}

// The first is known by itself, and better than what the pair leaves without the second; of the second by itself
// nothing is known.
TEST(SetTrials, AKnownSetIsNotFittedAgain) {
    EXPECT_EQ(tried_without(0.0), std::vector<std::string>{"axlebox_1"});
}

// One that came to a poor end is.
TEST(SetTrials, AKnownSetIsFittedAgainFromABetterPlace) {
    EXPECT_EQ(tried_without(1e9), (std::vector<std::string>{"bogie_1", "axlebox_1"}));
}

// A gain that is off by a hundredth beside another by a fifth. Where it would have to bring a million nats its fit ends
// at once; where it has to bring more than it does the pair is taken out.
TEST(SetTrials, WhatCannotBringEnoughIsGivenUpAndTakenOut) {
    TwoGains own(0.99);
    const FittedSet single = own.trials.try_set(own.result.retuned.fit, {own.first}, {}, 0.0);
    EXPECT_FALSE(own.trials.try_set(single.fit, {own.first, own.second}, {}, 0.0, false, 1e6).fit.converged);
    own.result.sets.pop_back();
    const FittedSet& pair = own.trials.try_set(single.fit, {own.first, own.second}, {}, 0.0);
    EXPECT_TRUE(pair.fit.converged);
    const double brings = pair.score() - single.score();
    EXPECT_GT(brings, 5.0);
    own.trials.drop_beside(single, 0.99 * brings);
    EXPECT_EQ(own.trials.leading().members(), 2U);
    own.trials.drop_beside(single, 1.01 * brings);
    EXPECT_EQ(own.trials.leading().members(), 1U);
    ASSERT_EQ(own.result.dropped.size(), 1U);
    EXPECT_EQ(own.result.dropped.front().score(), single.score() + brings)
        << "the report reads from it what its members bring";
}

// The second gain is there and stays, until the unseen part speaks against it: nothing is looked for beside the pair
// then.
TEST(SetTrials, WhatWouldNotBeNamedIsNotBuiltUpon) {
    TwoGains own(0.99);
    const FittedSet single = own.trials.try_set(own.result.retuned.fit, {own.first}, {}, 0.0);
    own.trials.try_set(single.fit, {own.first, own.second}, {}, 0.0);
    own.trials.drop_needless();
    EXPECT_EQ(own.trials.leading().members(), 2U);
    own.result.sets.back().held_out = single.held_out - 1.0;
    own.trials.drop_needless();
    EXPECT_EQ(own.trials.leading().members(), 1U);
    EXPECT_EQ(own.result.dropped.size(), 1U);
}

TEST(SetTrials, SinglesAreRanked) {
    TwoGains own(0.9);
    const double worse = own.trials.try_set(own.result.retuned.fit, {own.second}, {}, 0.0).score(),
                 better = own.trials.try_set(own.result.retuned.fit, {own.first}, {}, 0.0).score();
    own.trials.try_set(own.result.retuned.fit, {own.first, own.second}, {}, 0.0);
    own.trials.try_set(own.result.retuned.fit, {}, {"vehicle.bogie_mass_kg"}, 0.0);
    own.trials.try_set(own.result.retuned.fit, {own.first}, {}, 0.0);  // the same again
    ASSERT_GT(better, worse);
    EXPECT_EQ(own.trials.single(1)->score(), better);
    EXPECT_EQ(own.trials.single(2)->score(), worse);
    EXPECT_EQ(own.trials.single(3), nullptr) << "neither a pair nor a number";
}

// Of two other kinds in the place of the first one is worse by more than the second member brings, and of the same
// effect: it is not tried.
TEST(SetTrials, AWorseVariantIsNotSwappedIn) {
    for (const bool far_behind : {false, true}) {
        TwoGains own(0.9);
        const Candidate other{.instance = gain_of("axlebox_2", 1.1), .probe = gain_of("axlebox_2", 1.1)};
        FittedSet from = own.trials.try_set(own.result.retuned.fit, {own.first}, {}, 0.0);
        own.trials.try_set(own.result.retuned.fit, {other}, {}, 0.0);
        const double brought = own.trials.try_set(from.fit, {own.first, own.second}, {}, 0.0).score() - from.score();
        own.result.sets[1].log_prior += from.score() - own.result.sets[1].score() - (far_behind ? brought + 1.0 : 1.0);
        own.result.retuned.log_prior -= 1e6;  // whatever is worse than nothing is not swapped in anyway
        ASSERT_GT(own.result.sets[1].score(), own.result.retuned.score());
        own.said.clear();
        own.trials.swap_first(own.second, from, brought, 0.0);
        EXPECT_EQ(own.said.empty(), far_behind);
    }
}

}  // namespace
}  // namespace railpem::diagnosis
