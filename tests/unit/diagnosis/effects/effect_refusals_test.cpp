// What check() and apply() refuse, with the whole message.

#include <gtest/gtest.h>

#include <limits>

#include "tests/unit/diagnosis/effect_fixtures.hpp"

namespace railpem::diagnosis {
namespace {

std::string refusal(const EffectInstance& instance, bool force = false) {
    try {
        check(instance, some_numbers(), force);
    } catch (const parameters::ParameterError& error) {
        return error.what();
    }
    return "accepted";
}

std::string refusal_of(const EffectInstance& instance, pem::CaseParameters c) {
    try {
        apply(instance, some_numbers(), c);
    } catch (const parameters::ParameterError& error) {
        return error.what();
    }
    return "accepted";
}

TEST(EffectRefusals, Names) {
    EXPECT_EQ(refusal({.effect = "rail-damper"}), "accepted");
    EXPECT_EQ(refusal({.effect = "rail-shears"}).substr(0, 109),
              "effect.id: there is no effect 'rail-shears'; allowed: pad-frequency-stiffening, pad-preload-stiffening, "
              "pad-h");
    EXPECT_EQ(
        refusal({.effect = "rail-damper", .values = {{"mass", 10.0}}}),
        "effect.mass: 'rail-damper' has no 'mass'; allowed: mass_kg_per_m, frequency_hz, loss_factor, loss_exponent");
    EXPECT_EQ(refusal({.effect = "suspension-friction", .values = {{"stage", 1.0}}}),
              "effect.stage: 'stage' of 'suspension-friction' is a choice; allowed: primary, secondary");
    EXPECT_EQ(refusal({.effect = "rail-damper", .choices = {{"mass_kg_per_m", "ten"}}}),
              "effect.mass_kg_per_m: 'mass_kg_per_m' of 'rail-damper' cannot be a text; allowed: a number");
}

TEST(EffectRefusals, Ranges) {
    const EffectInstance steep{.effect = "pad-frequency-stiffening", .values = {{"exponent", 0.5}}};
    EXPECT_EQ(refusal(steep),
              "effect.exponent: 'exponent' of 'pad-frequency-stiffening' cannot be 0.5; allowed: a number between 0.02 "
              "and 0.35");
    EXPECT_EQ(refusal(steep, true), "accepted");
    const EffectInstance undefined{.effect = "rail-damper",
                                   .values = {{"frequency_hz", std::numeric_limits<double>::quiet_NaN()}}};
    const std::string message =
        "effect.frequency_hz: 'frequency_hz' of 'rail-damper' cannot be nan; allowed: a number between 30 and 6000, in "
        "Hz";
    EXPECT_EQ(refusal(undefined), message);
    EXPECT_EQ(refusal(undefined, true), message);
}

TEST(EffectRefusals, Choices) {
    EXPECT_EQ(
        refusal({.effect = "wheel-out-of-roundness", .choices = {{"wheel", "1"}}}),
        "effect.order: 'wheel-out-of-roundness' needs 'order' (number of waves around the circumference); allowed: "
        "a whole number between 1 and 60");
    EXPECT_EQ(
        refusal({.effect = "wheel-out-of-roundness", .choices = {{"wheel", "5"}, {"order", "3"}}}),
        "effect.wheel: 'wheel' of 'wheel-out-of-roundness' cannot be '5'; allowed: a whole number between 1 and 4");
    EXPECT_EQ(refusal({.effect = "timing-skew", .choices = {{"channel", "roof"}}}),
              "effect.channel: 'channel' of 'timing-skew' cannot be 'roof'; allowed: axlebox_1, axlebox_2, axlebox_3, "
              "axlebox_4, bogie_1, bogie_2, body_front, body_centre, body_rear");
    EXPECT_EQ(
        refusal({.effect = "parameter-error", .choices = {{"parameter", "vehicle.colour"}}}),
        "effect.parameter: 'parameter' of 'parameter-error' cannot be 'vehicle.colour'; allowed: the dotted key of "
        "a number of the case");
    EXPECT_EQ(refusal({.effect = "failed-fasteners", .values = {{"fraction", 0.1}}, .choices = {{"every", "8"}}}),
              "effect.every: 'failed-fasteners' has both 'every' and 'fraction'; allowed: one of them");
}

TEST(EffectRefusals, CasesThatForbidTheEffect) {
    pem::CaseParameters c = tests::paper_case(1);
    EXPECT_EQ(
        refusal_of({.effect = "sleeper-flexibility"}, c),
        "effect.id: no 'sleeper-flexibility': there is no sleeper in the case that could bend; allowed: a case with "
        "track.support.model = \"two-layer\", or support-compliance beside it");
    c.track.rail.beam = track::Beam::timoshenko;
    EXPECT_EQ(refusal_of({.effect = "rail-shear"}, c),
              "effect.id: no 'rail-shear': the rail of the case shears already; allowed: a case with track.rail.beam = "
              "\"euler\"; another shear coefficient is a parameter-error");
    c.track.pads.force_polynomial_n.clear();
    EXPECT_EQ(refusal_of({.effect = "pad-preload-stiffening"}, c),
              "effect.id: no 'pad-preload-stiffening': the case has no static curve of the pad, so the load does not "
              "stiffen it; allowed: a case with track.pads.force_polynomial_n or track.pads.curve_force_n");
    EXPECT_EQ(
        refusal_of({.effect = "parameter-error", .choices = {{"parameter", "contact.patch_half_length_m"}}}, c),
        "effect.parameter: 'contact.patch_half_length_m' is 0 and no factor changes that; allowed: a number of the "
        "case that is neither 0 nor infinite");
}

/// Effects that cannot be there twice refuse the second instance; all others accept it.
TEST(EffectRefusals, WhatCannotBeThereTwice) {
    std::vector<std::string> once;
    for (const Effect& effect : effects()) {
        pem::CaseParameters c = believed_case(effect.id);
        apply(typical_instance(effect), some_numbers(), c);
        try {
            apply(typical_instance(effect), some_numbers(), c);
        } catch (const parameters::ParameterError&) {
            once.push_back(effect.id);
        }
    }
    EXPECT_EQ(once, (std::vector<std::string>{"pad-hysteresis", "rail-shear", "support-compliance", "failed-fasteners",
                                              "body-bending", "wheelset-bending", "contact-filter"}));
}

}  // namespace
}  // namespace railpem::diagnosis
