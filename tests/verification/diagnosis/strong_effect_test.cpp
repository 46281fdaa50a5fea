// Effects so strong that retuning ends far from the truth, on recordings drawn with them.

#include <gtest/gtest.h>

#include <algorithm>

#include "diagnosis/diagnose.hpp"
#include "diagnosis/effects/effect.hpp"
#include "diagnosis/from_afar.hpp"
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

// Loads of two trains make a pad that follows them two different pads; a free correction is the same for both and shows little.
TEST(StrongEffect, PreloadUnderTwoLoads) {
    Synthesised made = synthesised(paper_believed({"vehicle.body_mass_kg", "vehicle.primary.stiffness_n_per_m", "vehicle.primary.damping_n_s_per_m", "vehicle.secondary.stiffness_n_per_m",
                                                   "vehicle.secondary.damping_n_s_per_m", "track.pads.static_stiffness_n_per_m", "track.pads.damping_n_s_per_m"}),
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

// From half of its frequency, or from twice, no climb leads to a resonance.
TEST(StrongEffect, TunedMassOnTheRailIsFoundFromAfar) {
    Synthesised made = synthesised(paper_believed({"vehicle.wheelset_mass_kg", "vehicle.primary.stiffness_n_per_m", "track.rail.second_moment_of_area_m4", "track.rail.mass_kg_per_m",
                                                   "track.pads.static_stiffness_n_per_m", "track.pads.damping_n_s_per_m", "contact.constant_m_per_n23"}),
                                   {22.2222, 33.0}, 60.0, nine_channels(), {.window_s = 2.0, .low_hz = 2.0, .high_hz = 175.0});
    struct Damper {
        double mass_kg_per_m, frequency_hz, loss_factor;
    };
    for (const Damper& hidden : {Damper{15.0, 120.0, 0.35}, Damper{24.4, 49.2, 0.2}}) {
        made.truth.effects = {{.effect = "rail-damper", .values = {{"mass_kg_per_m", hidden.mass_kg_per_m}, {"frequency_hz", hidden.frequency_hz}, {"loss_factor", hidden.loss_factor}}, .choices = {}}};
        made.draw(7);
        std::vector<Candidate> variants = candidates(made.believed, believed_trial(made.believed, made.observations), made.observations).candidates;
        std::erase_if(variants, [](const Candidate& own) { return own.instance.effect != "rail-damper"; });
        const std::vector<FittedSet> found = blunt_from_afar(made.believed, {}, {variants}, made.context(Part::fitted, 2), [](const Candidate&) {});
        ASSERT_EQ(found.size(), 1u);
        const std::map<std::string, double>& values = found.front().fit.trial.effects.back().values;
        EXPECT_NEAR(values.at("frequency_hz") / hidden.frequency_hz, 1.0, 0.05);
        EXPECT_NEAR(values.at("mass_kg_per_m") / hidden.mass_kg_per_m, 1.0, 0.2);
    }
}

// Beside friction alone no derivative leads to a mass on the rail: a rail of another mass, or one that shears, stands in for it.
TEST(StrongEffect, SecondOfTwoIsFoundFromAfarBesideTheFirst) {
    Synthesised made = synthesised(paper_believed({"vehicle.wheelset_mass_kg", "vehicle.secondary.damping_n_s_per_m", "track.rail.second_moment_of_area_m4", "track.rail.mass_kg_per_m",
                                                   "track.pads.static_stiffness_n_per_m", "track.pads.damping_n_s_per_m", "contact.constant_m_per_n23"}),
                                   {13.4, 39.9}, 60.0, nine_channels(), {.window_s = 2.0, .low_hz = 2.0, .high_hz = 175.0});
    made.truth.effects.push_back({.effect = "suspension-friction", .values = {{"force_n", 1000.0}}, .choices = {{"stage", "secondary"}}});
    made.truth.effects.push_back({.effect = "rail-damper", .values = {{"mass_kg_per_m", 14.6}, {"frequency_hz", 115.6}, {"loss_factor", 0.12}}, .choices = {}});
    made.draw(8);
    DiagnoseOptions options{.threads = 2};
    options.naming.without = all_but({"rail-damper", "suspension-friction", "rail-shear", "parameter-error"});
    const Diagnosis found = diagnose(made.believed, made.observations, options);
    ASSERT_EQ(found.omitted.size(), 2u);
    const auto damper = std::find_if(found.omitted.begin(), found.omitted.end(), [](const NamedEffect& own) { return own.instance.effect == "rail-damper"; });
    ASSERT_NE(damper, found.omitted.end());
    EXPECT_NEAR(damper->parameters.front().value, 14.6, 0.3);  // its 90 % interval in a marched record of the kind is 0.25 wide to either side
}

}  // namespace
}  // namespace railpem::diagnosis
