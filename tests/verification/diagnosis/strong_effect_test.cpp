// Effects so strong that retuning ends far from the truth, on recordings drawn with them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "diagnosis/diagnose.hpp"
#include "diagnosis/effects/effect.hpp"
#include "diagnosis/judge/model_error.hpp"
#include "diagnosis/search/from_afar.hpp"
#include "diagnosis/search/name_physics.hpp"
#include "tests/unit/diagnosis/synthesised_fixture.hpp"

namespace railpem::diagnosis {
namespace {

/// All that the catalogue has but these.
std::vector<std::string> all_but(const std::vector<std::string>& kept) {
    std::vector<std::string> others;
    for (const Effect& effect : effects())
        if (std::find(kept.begin(), kept.end(), effect.id) == kept.end()) others.push_back(effect.id);
    return others;
}

// Loads of two trains make a pad that follows them two different pads; a free correction is the same for both and shows
// little.
TEST(StrongEffect, PreloadUnderTwoLoads) {
    Synthesised made =
        synthesised(paper_believed({"vehicle.body_mass_kg", "vehicle.primary.stiffness_n_per_m",
                                    "vehicle.primary.damping_n_s_per_m", "vehicle.secondary.stiffness_n_per_m",
                                    "vehicle.secondary.damping_n_s_per_m", "track.pads.static_stiffness_n_per_m",
                                    "track.pads.damping_n_s_per_m"}),
                    {26.7, 20.6}, 60.0, nine_channels(), {.window_s = 2.0, .low_hz = 2.0, .high_hz = 175.0});
    made.shapes.front().payload_kg = 8000.0;
    made.truth.effects.push_back({.effect = "pad-preload-stiffening", .values = {{"strength", 0.7}}, .choices = {}});
    made.draw(6);
    DiagnoseOptions options{.threads = 2};
    options.naming.without = all_but({"pad-preload-stiffening", "failed-fasteners", "pad-frequency-stiffening"});
    const Diagnosis found = diagnose(made.believed, made.observations, options);
    ASSERT_EQ(found.omitted.size(), 1u);
    EXPECT_EQ(found.omitted.front().instance.effect, "pad-preload-stiffening");
    EXPECT_NEAR(found.omitted.front().parameters.front().value, 0.7, 0.07);
}

// What the report says that each of two brings is what the other by itself misses, fitted here by hand. 12 nats are
// what chance promises.
TEST(StrongEffect, EachOfTwoExplainsWhatTheOtherMisses) {
    Synthesised made =
        synthesised(paper_believed({"vehicle.wheelset_mass_kg", "vehicle.primary.stiffness_n_per_m",
                                    "track.pads.static_stiffness_n_per_m", "track.pads.damping_n_s_per_m"}),
                    {22.2222, 33.0}, 60.0, nine_channels(), {.window_s = 1.0, .low_hz = 4.0, .high_hz = 175.0});
    const EffectInstance exponent{.effect = "pad-frequency-stiffening", .values = {{"exponent", 0.25}}, .choices = {}},
        preload{.effect = "pad-preload-stiffening", .values = {{"strength", 1.0}}, .choices = {}};
    made.truth.effects = {exponent, preload};
    made.draw(6);
    DiagnoseOptions options{.threads = 2};
    options.naming.without = all_but({exponent.effect, preload.effect});
    const Diagnosis found = diagnose(made.believed, made.observations, options);
    ASSERT_EQ(found.omitted.size(), 2u);
    const double both = fitted_with(made, {exponent, preload}).log_likelihood;
    for (const NamedEffect& named : found.omitted) {
        const double missed =
            both - fitted_with(made, named.instance.effect == exponent.effect ? preload : exponent).log_likelihood;
        std::printf("%s: %.0f nats, missed without it %.0f\n", named.instance.effect.c_str(), named.nats_fitted,
                    missed);
        // what wheels meet alone takes a part of what is missed, in either fit another
        EXPECT_NEAR(named.nats_fitted, missed, 0.05 * missed) << named.instance.effect;
    }
}

/// What the blunt likelihood finds of a mass on the rail, alone and from afar.
std::map<std::string, double> damper_from_afar(Synthesised& made, double mass_kg_per_m, double frequency_hz,
                                               double loss_factor) {
    made.truth.effects = {
        {.effect = "rail-damper",
         .values = {{"mass_kg_per_m", mass_kg_per_m}, {"frequency_hz", frequency_hz}, {"loss_factor", loss_factor}},
         .choices = {}}};
    made.draw(7);
    std::vector<Candidate> variants =
        candidates(made.believed, believed_trial(made.believed, made.observations), made.observations).candidates;
    std::erase_if(variants, [](const Candidate& own) { return own.instance.effect != "rail-damper"; });
    return blunt_from_afar(made.believed, {}, {}, {variants}, made.context(Part::fitted, 2), [](const Candidate&) {})
        .at(0)
        .fit.trial.effects.back()
        .values;
}

const std::vector<std::string> kAxleAndTrack{
    "vehicle.wheelset_mass_kg",  "vehicle.primary.stiffness_n_per_m",   "track.rail.second_moment_of_area_m4",
    "track.rail.mass_kg_per_m",  "track.pads.static_stiffness_n_per_m", "track.pads.damping_n_s_per_m",
    "contact.constant_m_per_n23"};

// A mass on the rail is there. What bends the axles instead is climbed as far as it leads, or given up at once where
// the mass is known.
TEST(StrongEffect, WhatStaysBehindAKnownOneIsGivenUp) {
    Synthesised made = synthesised(paper_believed(kAxleAndTrack), {22.2222, 33.0}, 60.0, nine_channels(),
                                   {.window_s = 2.0, .low_hz = 2.0, .high_hz = 175.0});
    const EffectInstance mass{.effect = "rail-damper",
                              .values = {{"mass_kg_per_m", 30.0}, {"frequency_hz", 60.0}, {"loss_factor", 0.2}},
                              .choices = {}};
    made.truth.effects = {mass};
    made.draw(7);
    const LikelihoodContext context = made.context(Part::fitted, 2);
    std::vector<Candidate> bending =
        candidates(made.believed, believed_trial(made.believed, made.observations), made.observations).candidates;
    std::erase_if(bending, [](const Candidate& own) { return own.instance.effect != "wheelset-bending"; });
    const Fit known = fit_set(made.believed, {}, {{.instance = mass, .probe = mass}}, {}, {}, blunted(context, 0.1),
                              {.from_far = false})
                          .fit;
    int steps = 0, fewer = 0;
    const FittedSet alone =
        blunt_from_afar(made.believed, {}, {}, {bending}, context, [&](const Candidate&) { ++steps; }).at(0);
    const FittedSet behind =
        blunt_from_afar(
            made.believed, {}, {}, {bending}, context, [&](const Candidate&) { ++fewer; }, [] { return false; }, &known)
            .at(0);
    std::printf("known %.0f, alone %.0f after %d steps, behind %.0f after %d\n", known.log_posterior,
                alone.fit.log_posterior, steps, behind.fit.log_posterior, fewer);
    EXPECT_LT(fewer, steps);
}

// From half of its frequency, or from twice, no climb leads to a resonance: the next start of the grid is within 12 %.
// Found within 0.2 and 0.5 %; 5 and 20 % tell it from the next ones.
TEST(StrongEffect, TunedMassOnTheRailIsFoundFromAfar) {
    Synthesised made = synthesised(paper_believed(kAxleAndTrack), {22.2222, 33.0}, 60.0, nine_channels(),
                                   {.window_s = 2.0, .low_hz = 2.0, .high_hz = 175.0});
    const std::map<std::string, double> values = damper_from_afar(made, 15.0, 120.0, 0.35);
    EXPECT_NEAR(values.at("frequency_hz"), 120.0, 6.0);
    EXPECT_NEAR(values.at("mass_kg_per_m"), 15.0, 3.0);
}

// Where enough is spent the four effects that approached highest are climbed, and what is there is one of them. Else
// further ones, too, but none that begins worse than nothing: a flat loss factor did.
TEST(StrongEffect, TheMostPromisingAreClimbedWhateverIsSpent) {
    Synthesised made = synthesised(paper_believed(kAxleAndTrack), {22.2222, 33.0}, 30.0, nine_channels(),
                                   {.window_s = 2.0, .low_hz = 2.0, .high_hz = 120.0});
    made.truth.effects = {{.effect = "support-compliance",
                           .values = {{"mass_kg", 150.0}, {"stiffness_n_per_m", 1e8}, {"damping_n_s_per_m", 8e4}},
                           .choices = {}}};
    made.draw(7);
    const std::vector<Candidate> all =
        candidates(made.believed, believed_trial(made.believed, made.observations), made.observations).candidates;
    const std::vector<std::vector<Candidate>> variants = variants_from_afar(all, {}, [](Element element) {
        return element == Element::pad || element == Element::support || element == Element::rail;
    });
    ASSERT_GT(variants.size(), 4u);
    const auto fitted = [&](bool enough) {
        return blunt_from_afar(
            made.believed, {}, {}, variants, made.context(Part::fitted, 2), [](const Candidate&) {},
            [enough] { return enough; });
    };
    const std::vector<FittedSet> sets = fitted(true), all_sets = fitted(false);
    EXPECT_EQ(sets.size(), 4u);
    const auto best = std::max_element(sets.begin(), sets.end(), [](const FittedSet& a, const FittedSet& b) {
        return a.fit.log_posterior < b.fit.log_posterior;
    });
    EXPECT_TRUE(std::any_of(sets.begin(), sets.end(), [](const FittedSet& own) {
        return own.effects.front().instance.effect == "support-compliance";
    })) << best->effects.front().instance.effect;
    EXPECT_LT(all_sets.size(), variants.size());
    for (const FittedSet& own : all_sets) EXPECT_NE(own.effects.front().instance.effect, "pad-hysteresis");
}

// As they stand starts are ranked by the errors of the numbers, not by what is there: 100, 127 and 79 Hz came first,
// and were climbed to a mass of 2 kg/m at 30 Hz. As trial 38 of seed 85743307, pads half a tolerance softer than
// believed in the place of a third stiffer.
TEST(StrongEffect, TunedMassIsFoundBesideNumbersThatAreOff) {
    const std::vector<std::pair<std::string, double>> off{{"vehicle.body_mass_kg", 0.972},
                                                          {"vehicle.body_pitch_inertia_kg_m2", 1.023},
                                                          {"vehicle.bogie_pitch_inertia_kg_m2", 1.008},
                                                          {"vehicle.wheelset_mass_kg", 1.033},
                                                          {"vehicle.primary.stiffness_n_per_m", 0.974},
                                                          {"vehicle.primary.damping_n_s_per_m", 1.078},
                                                          {"vehicle.secondary.stiffness_n_per_m", 1.003},
                                                          {"vehicle.secondary.damping_n_s_per_m", 1.045},
                                                          {"track.rail.second_moment_of_area_m4", 0.992},
                                                          {"track.rail.mass_kg_per_m", 1.0086},
                                                          {"track.pads.static_stiffness_n_per_m", 0.85},
                                                          {"track.pads.damping_n_s_per_m", 1.093},
                                                          {"contact.constant_m_per_n23", 0.922},
                                                          {"vehicle.bogie_mass_kg", 1.0004}};
    std::vector<std::string> keys;
    for (const auto& [key, factor] : off) keys.push_back(key);
    Synthesised made = synthesised(paper_believed(keys), {37.4, 17.84}, 60.0, nine_channels(),
                                   {.window_s = 2.0, .low_hz = 2.0, .high_hz = 175.0});
    for (const auto& [key, factor] : off)
        made.believed.access.set(made.truth.numbers, key,
                                 factor * made.believed.access.get(made.believed.numbers, key));
    made.truth.numbers.irregularity.level_db += 0.65;
    made.truth.speed_m_per_s[0] *= 0.99956, made.truth.speed_m_per_s[1] *= 1.00381;
    const std::map<std::string, double> values = damper_from_afar(made, 24.4, 49.2, 0.2);
    EXPECT_NEAR(values.at("frequency_hz"), 49.2, 2.5);
    EXPECT_NEAR(values.at("mass_kg_per_m"), 24.4, 4.9);
}

// Beside friction alone no derivative leads to a mass on the rail: a rail of another mass, or one that shears, stands
// in for it.
TEST(StrongEffect, SecondOfTwoIsFoundFromAfarBesideTheFirst) {
    Synthesised made =
        synthesised(paper_believed({"vehicle.wheelset_mass_kg", "vehicle.secondary.damping_n_s_per_m",
                                    "track.rail.second_moment_of_area_m4", "track.rail.mass_kg_per_m",
                                    "track.pads.static_stiffness_n_per_m", "track.pads.damping_n_s_per_m",
                                    "contact.constant_m_per_n23"}),
                    {13.4, 39.9}, 60.0, nine_channels(), {.window_s = 2.0, .low_hz = 2.0, .high_hz = 175.0});
    made.truth.effects.push_back(
        {.effect = "suspension-friction", .values = {{"force_n", 1000.0}}, .choices = {{"stage", "secondary"}}});
    made.truth.effects.push_back({.effect = "rail-damper",
                                  .values = {{"mass_kg_per_m", 14.6}, {"frequency_hz", 115.6}, {"loss_factor", 0.12}},
                                  .choices = {}});
    made.draw(8);
    DiagnoseOptions options{.threads = 2};
    options.naming.without = all_but({"rail-damper", "suspension-friction", "rail-shear", "parameter-error"});
    const Diagnosis found = diagnose(made.believed, made.observations, options);
    ASSERT_EQ(found.omitted.size(), 2u);
    const auto damper = std::find_if(found.omitted.begin(), found.omitted.end(),
                                     [](const NamedEffect& own) { return own.instance.effect == "rail-damper"; });
    ASSERT_NE(damper, found.omitted.end());
    // its 90 % interval in a marched record of the kind is 0.25 wide to either side
    EXPECT_NEAR(damper->parameters.front().value, 14.6, 0.3);
}

// Failed fasteners stand in for a mass on the rail, and what is added to them is not what is there: in trial 10 of seed
// 80779460 second members took all the effort, and nothing was explained. Little enough is missed that nothing is
// sought bluntly before.
TEST(StrongEffect, IsSoughtFromAfarBeforeSecondMembers) {
    Synthesised made = synthesised(paper_believed(kAxleAndTrack), {38.2, 15.7, 24.8}, 60.0, nine_channels(),
                                   {.window_s = 2.0, .low_hz = 2.0, .high_hz = 120.0});
    made.truth.effects.push_back({.effect = "rail-damper",
                                  .values = {{"mass_kg_per_m", 8.8}, {"frequency_hz", 48.0}, {"loss_factor", 0.12}},
                                  .choices = {}});
    made.draw(9);
    NamingOptions options{.without = all_but({"rail-damper", "failed-fasteners"})};
    std::vector<std::string> said;
    options.progress = [&](const std::string& what, double) { said.push_back(what); };
    const LikelihoodContext context = made.context(Part::fitted, 2);
    const NamingResult found = name_physics(made.believed, context, options);
    ASSERT_FALSE(found.sets.empty());
    ASSERT_FALSE(misses_much(found.retuned.fit, context));
    EXPECT_EQ(found.sets.front().effects.front().instance.effect, "rail-damper");
    const auto afar = std::find(said.begin(), said.end(), "rail-damper from afar");
    ASSERT_NE(afar, said.end());
    EXPECT_EQ(std::count(said.begin(), afar, "screening the catalogue"), 1)
        << "for singles, and not for what might stand beside them";
}

}  // namespace
}  // namespace railpem::diagnosis
