// Probabilities of sets and places, of sets whose evidences are given.

#include "diagnosis/judge/posterior.hpp"

#include <gtest/gtest.h>

#include "tests/unit/diagnosis/given_sets.hpp"

namespace railpem::diagnosis {
namespace {

TEST(Posterior, HasOneUnknown) {
    const NamingResult naming = given_naming({given_set({"suspension-friction"}, {}, 1000.0, 300.0)});
    PlaceStudy study;
    study.friction = FrictionLaw{1.02, 0.3, 1.0};
    const std::vector<EffectSet> posterior = posterior_of(naming, decide(naming, study, thresholds));
    ASSERT_EQ(posterior.size(), 3u);
    for (const EffectSet& own : posterior) EXPECT_NEAR(own.probability, own.effects.empty() ? 0.0 : 0.5, 1e-12);
}

TEST(Posterior, GivesFrictionOfAnotherLawItsShare) {
    const NamingResult naming = given_naming({given_set({"suspension-friction", "sensor-gain"}, {}, 1000.0, 300.0)});
    PlaceStudy study;
    study.friction = FrictionLaw{1.02, 0.3, 1.0};
    const std::vector<EffectSet> posterior = posterior_of(naming, decide(naming, study, thresholds));
    double sum = 0.0, constant = 0.0, other = 0.0;
    for (const EffectSet& own : posterior) {
        sum += own.probability;
        if (own.effects == std::vector<std::string>{"suspension-friction", "sensor-gain"}) constant = own.probability;
        if (own.effects == std::vector<std::string>{"unknown", "sensor-gain"}) other = own.probability;
    }
    EXPECT_NEAR(sum, 1.0, 1e-12);
    EXPECT_NEAR(constant, 0.5, 1e-12);
    EXPECT_NEAR(other, 0.5, 1e-12);
}

// A play of the pads was a contact five times as nonlinear as Hertz's, and its place the contact.
TEST(Places, AreNotThoseOfWhatWouldBeStrongerThanItsPhysics) {
    PlaceStudy study;
    study.at_retuned = {{.element = Element::pad, .nats = 33000.0}, {.element = Element::contact, .nats = 330.0}};
    EXPECT_EQ(place_probabilities(given_naming({contact_beyond(1.2)}), study, {}).front().element, Element::pad);
    EXPECT_EQ(place_probabilities(given_naming({contact_beyond(1.05)}), study, {}).front().element, Element::contact);
    EXPECT_EQ(place_probabilities(
                  given_naming({leaning_number(given_set({}, {"contact.constant_m_per_n23"}, 1000.0, 300.0), 10.0)}),
                  study, {})
                  .front()
                  .element,
              Element::pad);
    // and another of a contact 2.3 times as soft
    FittedSet bent = given_set({"contact-nonlinearity"}, {}, 1000.0, 300.0);
    bent.fit.unknowns = {{.kind = UnknownKind::number, .name = "contact.constant_m_per_n23", .deviation = 0.15}};
    bent.fit.values = {5.3 * 0.15};
    EXPECT_EQ(place_probabilities(given_naming({bent}), study, {}).front().element, Element::pad);
    bent.fit.values = {3.9 * 0.15};
    EXPECT_EQ(place_probabilities(given_naming({bent}), study, {}).front().element, Element::contact);
    study.anonymous = {given_set({}, {}, 1000.0, 300.0)};  // an unknown as probable as the name
    study.anonymous.front().anonymous = {{.element = Element::rail, .channel = {}}};
    EXPECT_EQ(
        place_probabilities(given_naming({contact_beyond(1.2)}), study, {.unknown_score = 1000.0}).front().element,
        Element::rail);
}

TEST(Places, ShareASetByWhatItsMembersBring) {
    const NamingResult naming =
        given_naming({given_set({"sensor-gain", "rail-shear"}, {}, 1000.0, 10.0),
                      given_set({"rail-shear"}, {}, 900.0, 10.0), given_set({"sensor-gain"}, {}, 20.0, 10.0)});
    Decision decision;
    const std::vector<PlaceEvidence> places = place_probabilities(naming, {}, decision);
    EXPECT_EQ(places.front().element, Element::rail);
    EXPECT_NEAR(places.front().probability, 980.0 / 1080.0, 1e-6);
}

// Where no set tells what they explain alone: a free correction of the pads, which the case has, says nothing against
// ground, which it has not.
TEST(Places, OfEqualsTheFirstThatWasFound) {
    const NamingResult naming =
        given_naming({given_set({"support-compliance", "pad-preload-stiffening"}, {}, 1000.0, 300.0)});
    PlaceStudy study;
    study.at_retuned = {{.element = Element::pad, .nats = 11000.0},
                        {.element = Element::wheel, .nats = 1300.0},
                        {.element = Element::rail, .nats = 1400.0}};
    const std::vector<PlaceEvidence> places = place_probabilities(naming, study, {});
    ASSERT_EQ(places.size(), 4u);
    EXPECT_EQ(places[0].element, Element::support);
    EXPECT_EQ(places[1].element, Element::pad);
    EXPECT_EQ(places[2].element, Element::rail);
    EXPECT_EQ(places[3].element, Element::wheel);
}

// A set that does not stand has its places by what it explains, and what is left beside it the place where a free
// correction would bring more.
TEST(Places, AreThoseOfWhatIsLeftWhereThatIsMore) {
    const NamingResult naming = given_naming({given_set({"pad-preload-stiffening"}, {}, 1000.0, 300.0)});
    PlaceStudy study;
    study.at_retuned = {{.element = Element::wheel, .nats = 3000.0}, {.element = Element::pad, .nats = 1200.0}};
    study.at_named = {{.element = Element::wheel, .nats = 3000.0}};
    const Decision unexplained{.verdict = Verdict::unexplained};
    const std::vector<PlaceEvidence> places = place_probabilities(naming, study, unexplained);
    EXPECT_EQ(places[0].element, Element::wheel);
    EXPECT_NEAR(places[0].probability, 0.75, 1e-6);
    EXPECT_EQ(places[1].element, Element::pad);
    EXPECT_NEAR(places[1].probability, 0.25, 1e-6);
    study.at_named.front().nats = 500.0;
    EXPECT_EQ(place_probabilities(naming, study, unexplained).front().element, Element::pad);
    study.at_named.front().nats = 3000.0;
    // it stands: the rest is what its law leaves
    EXPECT_EQ(place_probabilities(naming, study, {.verdict = Verdict::explained}).front().element, Element::pad);
}

// Pads answer for rigid ground, which has no free correction: what is left at them beside ballast that gives way is the
// ground's, which changes along the line.
TEST(Places, OfWhatIsLeftAtThePadsBesideGroundThatGivesWayIsTheGround) {
    PlaceStudy study;
    study.at_named = {{.element = Element::pad, .nats = 3000.0}};
    const Decision unexplained{.verdict = Verdict::unexplained};
    EXPECT_EQ(
        place_probabilities(given_naming({given_set({"support-compliance"}, {}, 1000.0, 300.0)}), study, unexplained)
            .front()
            .element,
        Element::support);
    EXPECT_EQ(place_probabilities(given_naming({given_set({"rail-shear"}, {}, 1000.0, 300.0)}), study, unexplained)
                  .front()
                  .element,
              Element::pad);
    study.at_named.front().element = Element::wheel;
    EXPECT_EQ(
        place_probabilities(given_naming({given_set({"support-compliance"}, {}, 1000.0, 300.0)}), study, unexplained)
            .front()
            .element,
        Element::wheel);
}

// What one member explains alone is known of a set that was fitted, though it is no candidate any more.
TEST(Places, ShareASetByThoseThatWereDropped) {
    NamingResult naming = given_naming(
        {given_set({"sensor-gain", "rail-shear"}, {}, 1000.0, 300.0), given_set({"rail-shear"}, {}, 900.0, -10.0)});
    drop_superfluous(naming, thresholds);
    ASSERT_EQ(naming.sets.size(), 1u);
    const std::vector<PlaceEvidence> places = place_probabilities(naming, {}, {});
    EXPECT_EQ(places.front().element, Element::rail);
    // the gain brings 100 beside it, and it 1000 beside nothing
    EXPECT_NEAR(places.front().probability, 1000.0 / 1100.0, 1e-6);
}

TEST(Posterior, SumsToOne) {
    const NamingResult naming =
        given_naming({given_set({"rail-shear"}, {}, 2.0, 1.0), given_set({"body-bending"}, {}, 1.0, 1.0)});
    const Decision decision = decide(naming, {}, thresholds);
    double sum = 0.0;
    for (const EffectSet& own : posterior_of(naming, decision)) sum += own.probability;
    EXPECT_NEAR(sum, 1.0, 1e-12);
}

}  // namespace
}  // namespace railpem::diagnosis
