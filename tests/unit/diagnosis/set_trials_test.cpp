// What the fits of the search make of a comb of lines.

#include "diagnosis/set_trials.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "diagnosis/screen.hpp"
#include "tests/unit/diagnosis/synthesised_fixture.hpp"

namespace railpem::diagnosis {
namespace {

/// The set that dips every `spacing_m` make when they are fitted to records of two speeds in which `hidden` is.
FittedSet fitted_dips(const EffectInstance& hidden, double spacing_m) {
    Synthesised made = synthesised(paper_believed({"vehicle.bogie_mass_kg"}), {15.0, 22.0}, 60.0, {"bogie_1", "wheel_1", "wheel_2"}, kFine);
    made.truth.effects = {hidden};
    made.draw(1);
    const LikelihoodContext context = made.context();
    const NamingOptions options;
    NamingResult result;
    SetTrials trials(made.believed, context, options, result);
    trials.retune();
    const CandidateList list = candidates(made.believed, result.retuned.fit.trial, made.observations);
    const auto joints = std::find_if(list.candidates.begin(), list.candidates.end(), [](const Candidate& own) { return own.instance.effect == "rail-joints"; });
    result.candidates = {*joints};
    for (EffectInstance* instance : {&result.candidates[0].instance, &result.candidates[0].probe}) instance->values["spacing_m"] = spacing_m, instance->values["length_m"] = 0.3;
    const std::vector<Promise> promises = screen(result.retuned.fit, result.candidates, context);
    const FittedSet& best = trials.try_starts(result.retuned.fit, {promises.front()}, {}, {}, 0.0);
    std::printf("dips every %.1f m bring %.0f nats, score %.0f\n", spacing_m, best.fit.log_likelihood - result.retuned.fit.log_likelihood, best.score() - result.retuned.score());
    return best;
}

// A narrow band of roughness that the smooth irregularity does not take: lines every 0.62 and 0.91 Hz bring some 50 nats, in whatever places they are.
TEST(SetTrials, ACombThatIsANoiseCannotBe) {
    for (const auto& [wavelength_m, bandwidth] : {std::pair{0.35, 0.03}, {0.6, 0.1}}) {
        const FittedSet dips = fitted_dips({.effect = "rail-corrugation", .values = {{"wavelength_m", wavelength_m}, {"relative_bandwidth", bandwidth}, {"rms_m", 1e-3}}, .choices = {}}, 24.3);
        EXPECT_TRUE(std::isfinite(dips.fit.log_evidence));
        EXPECT_TRUE(std::isinf(dips.score())) << wavelength_m;
    }
}

// 271 nats: lines where there should be none gain less than half of it.
TEST(SetTrials, ACombThatIsThereStays) {
    const FittedSet dips = fitted_dips({.effect = "rail-joints", .values = {{"spacing_m", 24.3}, {"depth_m", 1e-3}, {"length_m", 0.5}}, .choices = {}}, 24.3);
    EXPECT_TRUE(std::isfinite(dips.score()));
}

EffectInstance gain_of(const std::string& channel, double gain) { return {.effect = "sensor-gain", .values = {{"gain", gain}}, .choices = {{"channel", channel}}}; }

/// Gains of two channels, sought one after the other; what the search then tries without either of them, by name.
std::vector<std::string> tried_without(double known_is_worse_by) {
    Synthesised made = synthesised(paper_believed({"vehicle.bogie_mass_kg"}), {20.0}, 60.0, {"bogie_1", "wheel_1", "wheel_2"}, kSmall);
    made.truth.effects = {gain_of("bogie_1", 1.2), gain_of("axlebox_1", 0.8)};
    made.draw(1);
    const LikelihoodContext context = made.context();
    std::vector<std::string> said;
    NamingOptions options;
    options.progress = [&](const std::string& what, double) { said.push_back(what); };
    NamingResult result;
    SetTrials trials(made.believed, context, options, result);
    trials.retune();
    const Candidate first{.instance = made.truth.effects[0], .probe = made.truth.effects[0]}, second{.instance = made.truth.effects[1], .probe = made.truth.effects[1]};
    trials.try_set(result.retuned.fit, {first}, {}, 0.0);
    trials.try_set(result.retuned.fit, {first, second}, {}, 0.0);
    EXPECT_EQ(trials.leading().members(), 2u);
    EXPECT_TRUE(result.sets[0].fit.converged);
    result.sets[0].fit.log_posterior -= known_is_worse_by;
    said.clear();
    trials.prune();
    const auto of = [&](const Candidate& own) { return std::find(said.begin(), said.end(), label_of(own.instance)) != said.end(); };
    std::vector<std::string> tried;
    for (const Candidate& own : {first, second})
        if (of(own)) tried.push_back(own.instance.choices.at("channel"));
    return tried;
}

// The first is known by itself, and better than what the pair leaves without the second; of the second by itself nothing is known.
TEST(SetTrials, AKnownSetIsNotFittedAgain) { EXPECT_EQ(tried_without(0.0), std::vector<std::string>{"axlebox_1"}); }

// One that came to a poor end is.
TEST(SetTrials, AKnownSetIsFittedAgainFromABetterPlace) { EXPECT_EQ(tried_without(1e9), (std::vector<std::string>{"bogie_1", "axlebox_1"})); }

// A gain that is off by a hundredth beside another by a fifth. Where it would have to bring a million nats its fit ends at once; where it has to bring more than it does the pair is taken out.
TEST(SetTrials, WhatCannotBringEnoughIsGivenUpAndTakenOut) {
    Synthesised made = synthesised(paper_believed({"vehicle.bogie_mass_kg"}), {20.0}, 60.0, {"bogie_1", "wheel_1", "wheel_2"}, kSmall);
    made.truth.effects = {gain_of("bogie_1", 1.2), gain_of("axlebox_1", 0.99)};
    made.draw(1);
    const LikelihoodContext context = made.context();
    const NamingOptions options;
    NamingResult result;
    SetTrials trials(made.believed, context, options, result);
    trials.retune();
    const Candidate first{.instance = made.truth.effects[0], .probe = made.truth.effects[0]}, second{.instance = made.truth.effects[1], .probe = made.truth.effects[1]};
    const FittedSet single = trials.try_set(result.retuned.fit, {first}, {}, 0.0);
    EXPECT_FALSE(trials.try_set(single.fit, {first, second}, {}, 0.0, false, 1e6).fit.converged);
    result.sets.pop_back();
    const FittedSet& pair = trials.try_set(single.fit, {first, second}, {}, 0.0);
    EXPECT_TRUE(pair.fit.converged);
    const double brings = pair.score() - single.score();
    EXPECT_GT(brings, 5.0);
    trials.drop_beside(single, 0.99 * brings);
    EXPECT_EQ(trials.leading().members(), 2U);
    trials.drop_beside(single, 1.01 * brings);
    EXPECT_EQ(trials.leading().members(), 1U);
    ASSERT_EQ(result.dropped.size(), 1U);
    EXPECT_EQ(result.dropped.front().score(), single.score() + brings) << "the report reads from it what its members bring";
}

}  // namespace
}  // namespace railpem::diagnosis
