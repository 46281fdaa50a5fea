// What an effect would have to be like beyond the range of its physics, and free corrections fitted from afar, on
// recordings drawn with something that has no name.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "diagnosis/diagnose.hpp"
#include "diagnosis/effects/effect.hpp"
#include "diagnosis/hypotheses/fitted_set.hpp"
#include "diagnosis/hypotheses/locate.hpp"
#include "diagnosis/search/from_afar.hpp"
#include "diagnosis/search/name_physics.hpp"
#include "tests/unit/diagnosis/synthesised_fixture.hpp"

namespace railpem::diagnosis {
namespace {

Synthesised two_speeds(double high_hz) {
    return synthesised(paper_believed({"vehicle.bogie_mass_kg", "vehicle.wheelset_mass_kg",
                                       "vehicle.primary.stiffness_n_per_m", "vehicle.primary.damping_n_s_per_m"}),
                       {15.0, 80.0 / 3.6}, 60.0, nine_channels(), {.window_s = 2.0, .low_hz = 2.0, .high_hz = high_hz});
}

// An absorber of 80 kg at 45 Hz on an axle of 1350 kg is to everything else a mode at 45·√(1 + 80/1350) = 46.3 Hz of
// modal mass 1350·1430/80 = 24 t of a wheelset of 1430 kg: below the frequencies and above the masses of axles that
// bend.
TEST(BeyondRange, AnAbsorberOnTheAxlesActsLikeAnAxleThatBendsTooLow) {
    Synthesised made = two_speeds(80.0);
    const EffectInstance mode{.effect = "wheelset-bending",
                              .values = {{"frequency_hz", 46.3}, {"damping_ratio", 0.08}, {"modal_mass_kg", 24e3}},
                              .choices = {}};
    made.truth.effects = {mode};
    made.draw(6);
    const LikelihoodContext context = made.context(Part::fitted, 2);
    const FittedSet retuned = fit_set(made.believed, Fit{}, {}, {}, {}, context, {});
    Candidate bending{.instance = {.effect = "wheelset-bending",
                                   .values = {{"frequency_hz", 55.0}, {"damping_ratio", 0.05}, {"modal_mass_kg", 15e3}},
                                   .choices = {}}};
    const FittedSet within = fit_set(made.believed, retuned.fit, {bending}, {}, {}, context, {.from_far = false});
    ASSERT_GT(nats_beyond_range(within), 2.0);
    const FittedSet beyond = fit_beyond_range(made.believed, within, context, {}).value();
    const EffectInstance& found = beyond.fit.trial.effects.back();
    std::printf("within %.0f, beyond %.0f: %.2f Hz, %.3f, %.0f kg\n", within.score(), beyond.score(),
                found.values.at("frequency_hz"), found.values.at("damping_ratio"), found.values.at("modal_mass_kg"));
    EXPECT_GT(beyond.score(), within.score() + 12.0);
    EXPECT_EQ(beyond.anonymous.front().element, Element::wheel);
    for (std::size_t u = 0; u < beyond.fit.unknowns.size(); ++u)
        if (const EffectParameter* parameter = parameter_of(beyond.fit.unknowns[u])) {
            // one in 16 000 by chance
            EXPECT_NEAR(beyond.fit.values[u], to_coordinate(*parameter, mode.values.at(parameter->name)),
                        4.0 * beyond.fit.deviation(u))
                << parameter->name;
        }
}

// A mode of axles at 36 Hz leans on the 50 Hz of its range, and a gain that is off brings little beside it; beyond its
// range the mode explains more than twice what both do. The gain of a second sensor, which is off, too, is not looked
// for beside it.
TEST(BeyondRange, EndsTheSearchForThirdMembers) {
    Synthesised made = two_speeds(80.0);
    const auto gain_of = [](const std::string& channel) {
        return EffectInstance{.effect = "sensor-gain", .values = {{"gain", 1.005}}, .choices = {{"channel", channel}}};
    };
    made.truth.effects = {{.effect = "wheelset-bending",
                           .values = {{"frequency_hz", 36.0}, {"damping_ratio", 0.05}, {"modal_mass_kg", 1500.0}},
                           .choices = {}},
                          gain_of("bogie_1"),
                          gain_of("bogie_2")};
    made.draw(6);
    bool asked = false;
    NamingOptions options;
    options.progress = [&](const std::string& what, double) {
        asked = asked || what == "the best single beyond its range";
    };
    for (const Effect& effect : effects())
        if (effect.id != "wheelset-bending" && effect.id != "sensor-gain") options.without.push_back(effect.id);
    const NamingResult found = name_physics(made.believed, made.context(Part::fitted, 2), options);
    const auto bends_among = [&](std::size_t members) {
        return std::any_of(found.sets.begin(), found.sets.end(), [&](const FittedSet& set) {
            return set.members() == members && set.effects.front().instance.effect == "wheelset-bending";
        });
    };
    EXPECT_TRUE(asked);
    EXPECT_TRUE(bends_among(2));
    EXPECT_FALSE(bends_among(3));
}

// Bogies three times as heavy are a wrong number, 4.2 times as heavy are not: where nothing else can be named, nothing
// is, and what remains says why.
TEST(BeyondRange, ANumberFurtherOffThanAWrongOneIsSaidAndNotNamed) {
    DiagnoseOptions options{.threads = 2};
    for (const Effect& effect : effects())
        if (effect.id != "parameter-error") options.naming.without.push_back(effect.id);
    for (const double factor : {3.0, 4.2}) {
        Synthesised made =
            synthesised(paper_believed({"vehicle.bogie_mass_kg"}), {20.0}, 60.0, {"bogie_1", "wheel_1"}, kSmall);
        made.believed.uncertain.front().tolerance = 0.005;  // so well known that retuning does not follow
        made.truth.numbers.vehicle.bogie_mass_kg *= factor;
        made.draw(7);
        const Diagnosis found = diagnose(made.believed, made.observations, options);
        const bool said = std::any_of(found.remains.begin(), found.remains.end(), [](const std::string& own) {
            return own.starts_with("vehicle.bogie_mass_kg would have to be further off than by a factor of 4,");
        });
        EXPECT_EQ(found.verdict, factor < 4.0 ? Verdict::explained : Verdict::unexplained) << found.statement;
        EXPECT_EQ(found.omitted.empty(), factor > 4.0);
        EXPECT_EQ(said, factor > 4.0);
    }
}

/// Records of a car whose bogies a linkage ties to each other.
Synthesised linkage_of_the_bogies() {
    Synthesised made = two_speeds(60.0);
    lanes::FactorCurve spring;
    const double stiffness = 2e6, mass = made.believed.numbers.vehicle.bogie_mass_kg / 2.0;
    for (double f = 2.0; f < 100.0; f *= 1.2) {
        spring.frequency_hz.push_back(f);
        spring.value.push_back(-stiffness / (mass * std::pow(2.0 * std::numbers::pi * f, 2)));
    }
    made.truth.numbers.modifiers.vehicle.between_bogies.rear = spring;
    made.draw(8);
    return made;
}

// Four numbers are retuned: few enough for a free correction fitted from there to arrive, and the one from afar has to
// come as near.
TEST(CorrectionsFromAfar, FindALinkageOfTheBogies) {
    const Synthesised made = linkage_of_the_bogies();
    const LikelihoodContext context = made.context(Part::fitted, 2);
    const FittedSet retuned = fit_set(made.believed, Fit{}, {}, {}, {}, context, {});
    const LocatedEvidence first = locate(retuned.fit, context).front();
    const FittedSet near =
        fit_correction(made.believed, retuned, first, context, {.iterations = 12, .from_far = false});
    const std::vector<FittedSet> sets =
        sharpened_corrections(made.believed, blunt_corrections(made.believed, context, [](const std::string&) {}),
                              context, [](const std::string&) {});
    ASSERT_FALSE(sets.empty());
    const FittedSet& best = *std::max_element(
        sets.begin(), sets.end(), [](const FittedSet& a, const FittedSet& b) { return a.score() < b.score(); });
    std::printf("retuned %.0f; from there, %s: %.0f; from afar, %s: %.0f\n", retuned.score(),
                element_name(first.place.element).c_str(), near.score(),
                element_name(best.anonymous.front().element).c_str(), best.score());
    EXPECT_EQ(best.anonymous.front().element, Element::bogie);
    EXPECT_TRUE(best.anonymous.front().attached);
    EXPECT_GT(best.score(), near.score() - 5.0);  // nats: what decides between sets
}

// No name comes near what a free correction explains: the search ends there, and what it has fitted is left to the
// study of the places.
TEST(CorrectionsFromAfar, ALinkageOfTheBogiesEndsTheSearchForNames) {
    const Synthesised made = linkage_of_the_bogies();
    std::vector<std::string> said;
    NamingOptions options;
    options.progress = [&](const std::string& what, double) { said.push_back(what); };
    const NamingResult found = name_physics(made.believed, made.context(Part::fitted, 2), options);
    EXPECT_LE(found.sets.size(), 1u) << "the best single may have been sharpened before";
    ASSERT_FALSE(found.blunt_corrections.sets.empty());
    EXPECT_EQ(found.blunt_corrections.sets.front().anonymous.front().element, Element::bogie);
    EXPECT_EQ(said.back().find("free correction"), 0u) << said.back();
}

}  // namespace
}  // namespace railpem::diagnosis
