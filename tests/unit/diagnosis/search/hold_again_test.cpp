#include "diagnosis/search/hold_again.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "diagnosis/diagnose.hpp"
#include "diagnosis/judge/verdict.hpp"
#include "diagnosis/observations/held_distortion.hpp"
#include "tests/unit/diagnosis/synthesised_fixture.hpp"

namespace railpem::diagnosis {
namespace {

constexpr double kHeavier = 1.8;

/// Records at high speed whose wheelsets are heavier than believed, drawn with what their contacts distort; the
/// observations hold them as believed.
Synthesised heavier_wheelsets() {
    Synthesised made =
        synthesised(paper_believed({"vehicle.wheelset_mass_kg", "vehicle.primary.stiffness_n_per_m",
                                    "track.pads.damping_n_s_per_m"}),
                    {33.0, 39.0}, 60.0, nine_channels(), {.window_s = 4.0, .low_hz = 2.0, .high_hz = 175.0});
    made.truth.numbers.vehicle.wheelset_mass_kg *= kHeavier;
    pem::CaseParameters heavier = made.believed.numbers;
    heavier.vehicle.wheelset_mass_kg *= kHeavier;
    made.draw(11);  // linear: only for the power of the wheels
    made.shapes = made.observations;
    for (Observation& own : made.shapes) hold_contact_distortion(own, heavier);
    made.draw(12);
    for (Observation& own : made.observations) hold_contact_distortion(own, made.believed.numbers);
    return made;
}

FittedSet nonlinear_contact(const Synthesised& made, const Fit& near) {
    Candidate contact;
    contact.instance = {.effect = "contact-nonlinearity", .values = {{"factor", 1.5}}, .choices = {}};
    contact.probe = contact.instance;
    return fit_set(made.believed, near, {contact}, {"vehicle.wheelset_mass_kg"}, {}, made.context(),
                   {.from_far = false});
}

// Above the springs a wheel's force is its mass times what was recorded of it.
TEST(HoldAgain, ForcesGoWithTheMassThatWasFound) {
    const Synthesised made = heavier_wheelsets();
    FittedSet found;
    found.fit.trial = made.truth;
    const std::vector<Observation> held = held_again(found, made.believed, made.observations);
    const double ratio = held.front().expectation.contacts.force_variation /
                         made.observations.front().expectation.contacts.force_variation;
    EXPECT_NEAR(ratio, kHeavier, 0.15 * kHeavier) << "the suspension's own force is the rest";
}

// What a contact distorts goes with its own compliance: one that retuning finds a third off is held again, with or
// without a name.
TEST(HoldAgain, AContactThatIsAThirdOffWasHeldAsAnother) {
    const BelievedCase believed = paper_believed({"contact.constant_m_per_n23"});
    for (const auto& [factor, rests] : {std::pair(1.2, false), std::pair(1.5, true), std::pair(0.6, true)}) {
        NamingResult naming;
        naming.retuned.fit.trial.numbers = believed.numbers;
        believed.access.set(naming.retuned.fit.trial.numbers, "contact.constant_m_per_n23",
                            factor * believed.uncertain.front().value);
        EXPECT_EQ(rests_on_held_forces(naming, believed), rests) << factor;
    }
}

// Marched such a record was `explained` by both.
TEST(HoldAgain, AContactThatSeemedToBendMoreIsHertz) {
    const Synthesised made = heavier_wheelsets();
    NamingResult naming;
    const Trial trial = believed_trial(made.believed, made.observations);
    std::vector<Unknown> unknowns = nuisance_unknowns(made.believed, made.observations);
    const std::vector<double> start = means(unknowns);
    naming.retuned.fit = fit(trial, unknowns, start, made.context(), {});
    const FittedSet heavier =
        fit_set(made.believed, naming.retuned.fit, {}, {"vehicle.wheelset_mass_kg"}, {}, made.context(), {});
    naming.sets = {nonlinear_contact(made, heavier.fit), heavier};
    ASSERT_GT(naming.sets[0].score(), naming.sets[1].score() + 5.0) << "as believed the forces are too small";
    ASSERT_TRUE(rests_on_held_forces(naming, made.believed));
    const std::vector<Observation> held = held_again(naming.sets[0], made.believed, made.observations);
    LikelihoodContext context = made.context();
    context.observations = &held;
    fit_again(naming, made.believed, context);
    drop_superfluous(naming, VerdictThresholds{});
    ASSERT_FALSE(naming.sets.empty());
    EXPECT_TRUE(naming.sets.front().effects.empty()) << naming.sets.front().fit.trial.effects[0].values.at("factor")
                                                     << ", " << naming.sets.front().score() - naming.retuned.score();
    EXPECT_EQ(naming.sets.front().released, std::vector<std::string>{"vehicle.wheelset_mass_kg"});
    EXPECT_FALSE(rests_on_held_forces(naming, made.believed));
}

}  // namespace
}  // namespace railpem::diagnosis
