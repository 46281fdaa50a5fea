// Whether recordings agree about an effect's parameter, on recordings drawn with one value and with several.

#include "diagnosis/judge/constancy.hpp"

#include <gtest/gtest.h>

#include "diagnosis/diagnose.hpp"
#include "tests/unit/diagnosis/synthesised_fixture.hpp"

namespace railpem::diagnosis {
namespace {

const EffectInstance kHung{.effect = "bogie-mounted-mass",
                           .values = {{"mass_kg", 400.0}, {"frequency_hz", 20.0}, {"damping_ratio", 0.1}},
                           .choices = {}};

/// Three speeds; the mass on the bogies, and what it is in each.
Synthesised three_masses(const std::vector<double>& masses_kg) {
    Synthesised made = synthesised(paper_believed({"vehicle.bogie_mass_kg"}), {15.0, 22.2, 33.0}, 60.0,
                                   {"body", "bogie_1", "wheel_1"}, kSmall);
    for (std::size_t o = 0; o < masses_kg.size(); ++o) {
        made.truth.effects = {kHung};
        made.truth.effects[0].values["mass_kg"] = masses_kg[o];
        made.observations.push_back(synthesise(made.shapes[o], o, made.truth, made.believed, 7));
    }
    return made;
}

/// The fit of one mass to all recordings, and the mass as each of them would have it.
ParameterByRecording mass_of(const Synthesised& made) {
    const Fit own = fitted_with(made, kHung);
    for (const ParameterByRecording& one : constancy(own, made.context()))
        if (own.unknowns[one.unknown].name == "bogie-mounted-mass.mass_kg") return one;
    ADD_FAILURE() << "no recording speaks of the mass";
    return {};
}

TEST(Constancy, IsNoSurpriseWhereOneValueHolds) {
    const ParameterByRecording mass = mass_of(three_masses({400.0, 400.0, 400.0}));
    ASSERT_EQ(mass.observation, (std::vector<std::size_t>{0, 1, 2}));
    EXPECT_LT(mass.nats, 7.0);  // half a χ² of two degrees of freedom is larger once in a thousand: e⁻⁷
    for (const double value : mass.value) EXPECT_NEAR(value, 400.0, 40.0);
}

TEST(Constancy, SpeaksWhereEveryRecordingHasAnotherValue) {
    const ParameterByRecording mass = mass_of(three_masses({300.0, 400.0, 600.0}));
    EXPECT_GT(mass.nats, VerdictThresholds{}.residual);
    ASSERT_EQ(mass.value.size(), 3u);
    EXPECT_LT(mass.value[0], 0.9 * mass.value[1]);  // to first order of a ratio of 0.75 and of 1.5
    EXPECT_GT(mass.value[2], 1.2 * mass.value[1]);
}

TEST(Constancy, AsksNothingOfASingleRecording) {
    Synthesised made =
        synthesised(paper_believed({"vehicle.bogie_mass_kg"}), {22.2}, 60.0, {"body", "bogie_1", "wheel_1"}, kSmall);
    made.truth.effects = {kHung};
    made.draw(3);
    Trial trial = made.truth;
    std::vector<Unknown> unknowns = nuisance_unknowns(made.believed, made.observations);
    std::vector<double> start = means(unknowns);
    for (const Unknown& unknown : effect_unknowns(kHung, 0)) unknowns.push_back(unknown), start.push_back(unknown.mean);
    EXPECT_TRUE(constancy(fit(trial, unknowns, start, made.context()), made.context()).empty());
}

}  // namespace
}  // namespace railpem::diagnosis
