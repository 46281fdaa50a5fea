// Where a spring that the case does not know acts, on recordings drawn with it.

#include "diagnosis/hypotheses/locate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>

#include "tests/unit/diagnosis/synthesised_fixture.hpp"

namespace railpem::diagnosis {
namespace {

/// A spring as a multiple of a mass: −k/(mω²).
lanes::FactorCurve spring(double stiffness_n_per_m, double mass_kg) {
    lanes::FactorCurve curve;
    for (double f = 2.0; f < 200.0; f *= 1.2) {
        const double omega = 2.0 * std::numbers::pi * f;
        curve.frequency_hz.push_back(f);
        curve.value.push_back(-stiffness_n_per_m / (mass_kg * omega * omega));
    }
    return curve;
}

std::vector<LocatedEvidence> located(const std::function<void(pem::CaseParameters&)>& add) {
    Synthesised made =
        synthesised(paper_believed({"vehicle.body_mass_kg", "vehicle.body_pitch_inertia_kg_m2", "vehicle.bogie_mass_kg",
                                    "vehicle.secondary.stiffness_n_per_m", "vehicle.secondary.damping_n_s_per_m",
                                    "vehicle.primary.stiffness_n_per_m"}),
                    {80.0 / 3.6}, 60.0, nine_channels(), {.window_s = 2.0, .low_hz = 2.0, .high_hz = 40.0});
    add(made.truth.numbers);
    made.draw(5);
    const std::vector<Unknown> unknowns = nuisance_unknowns(made.believed, made.observations);
    const Fit retuned =
        fit(believed_trial(made.believed, made.observations), unknowns, means(unknowns), made.context(Part::fitted, 2));
    std::vector<LocatedEvidence> places = locate(retuned, made.context(Part::fitted, 2));
    for (std::size_t i = 0; i < 3; ++i)
        std::printf("%s%s %.0f; ", element_name(places[i].place.element).c_str(),
                    places[i].place.attached ? " (attached)"
                    : places[i].place.forces ? " (forces)"
                                             : "",
                    places[i].nats);
    std::printf("\n");
    return places;
}

// A factor on the inertia of the body cannot say that heave and pitch are coupled: sensors of the body would come
// first.
TEST(Locate, BufferAtAnEndOfTheBody) {
    const auto places = located([](pem::CaseParameters& own) {
        own.modifiers.vehicle.body_attachments.rear = spring(3e5, own.vehicle.body_mass_kg / 2.0);
    });
    EXPECT_EQ(places.front().place.element, Element::body);
    EXPECT_TRUE(places.front().place.attached);
}

// Nor can factors on the inertia of one bogie or both say that one moves the other.
TEST(Locate, LinkBetweenTheBogies) {
    const auto places = located([](pem::CaseParameters& own) {
        own.modifiers.vehicle.between_bogies.rear = spring(3e5, own.vehicle.bogie_mass_kg / 2.0);
    });
    EXPECT_EQ(places.front().place.element, Element::bogie);
    EXPECT_TRUE(places.front().place.attached);
}

// Forces that arise in the secondary suspension, 10 000 N²/Hz at 8 Hz and less beside it: no factor on a stiffness
// makes bogies and body vibrate incoherently with all else, and the noise of two bogie sensors would stand in for it.
TEST(Locate, ForcesOfTheSecondarySuspension) {
    const auto places = located([](pem::CaseParameters& own) {
        own.modifiers.secondary_forces = {
            .frequency_hz = {3.0, 8.0, 20.0}, .reference_n2_per_hz = {1e3, 1e4, 1e2}, .share = {1.0, 1.0, 1.0}};
    });
    EXPECT_EQ(places.front().place.element, Element::secondary);
    EXPECT_TRUE(places.front().place.forces);
}

// A hundredth of the irregularity's power, from 8 to 30 Hz, that each wheel meets by itself (seats that are not alike):
// forces of the primary suspension would stand in for it, at half of its nats.
TEST(Locate, WhatEachWheelMeetsByItself) {
    const auto places = located([](pem::CaseParameters& own) {
        own.modifiers.wheels_own = {.frequency_hz = {6.0, 8.0, 30.0, 35.0}, .share = {0.0, 0.01, 0.01, 0.0}};
    });
    EXPECT_EQ(places.front().place.element, Element::pad);
    EXPECT_TRUE(places.front().place.forces);
    EXPECT_GT(places.front().nats, 1.2 * places[1].nats);
}

}  // namespace
}  // namespace railpem::diagnosis
