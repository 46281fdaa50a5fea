// What differs from wheel to wheel at the pads, fitted to recordings drawn with it: of the ground where it resonates.

#include <gtest/gtest.h>

#include <cstdio>

#include "diagnosis/hypotheses/fitted_set.hpp"
#include "diagnosis/hypotheses/locate.hpp"
#include "diagnosis/judge/ground_resonance.hpp"
#include "tests/unit/diagnosis/synthesised_fixture.hpp"

namespace railpem::diagnosis {
namespace {

/// The place of what each wheel meets by itself.
Element place_of(const pem::WheelsOwn& own) {
    Synthesised made = synthesised(
        paper_believed({"vehicle.bogie_mass_kg", "vehicle.wheelset_mass_kg", "vehicle.primary.stiffness_n_per_m"}),
        {15.0, 80.0 / 3.6}, 60.0, nine_channels(), {.window_s = 2.0, .low_hz = 2.0, .high_hz = 120.0});
    made.truth.numbers.modifiers.wheels_own = own;
    made.draw(5);
    const LikelihoodContext context = made.context(Part::fitted, 2);
    const FittedSet retuned = fit_set(made.believed, Fit{}, {}, {}, {}, context, {});
    const std::vector<LocatedEvidence> places = locate(retuned.fit, context);
    EXPECT_EQ(places.front().place.element, Element::pad);
    PlaceStudy study;
    study.anonymous = {
        fit_correction(made.believed, retuned, places.front(), context, {.iterations = 12, .from_far = false})};
    for (const double share : study.anonymous.front().fit.trial.numbers.modifiers.wheels_own.share)
        std::printf("%.5f ", share);
    std::printf("\n");
    tell_ground_from_pads(study);
    return study.anonymous.front().anonymous.front().element;
}

// Ground at 31 Hz that wanders by a third either way, at a node of the correction (nodes at 15.5, 30.6 and 60.6 Hz
// here).
TEST(GroundOrPad, ResonancesAreOfTheGround) {
    EXPECT_EQ(place_of({.frequency_hz = {18.0, 24.0, 31.0, 40.0, 52.0}, .share = {0.0, 0.003, 0.006, 0.003, 0.0}}),
              Element::support);
}

// As a play of 0.1 mm distorts.
TEST(GroundOrPad, WhatRisesToTheEndIsOfThePads) {
    EXPECT_EQ(place_of({.frequency_hz = {9.0, 18.7, 39.4, 83.1, 120.0}, .share = {0.0, 0.004, 0.003, 0.015, 0.025}}),
              Element::pad);
}

}  // namespace
}  // namespace railpem::diagnosis
