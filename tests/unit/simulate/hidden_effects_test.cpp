#include "simulate/effects/hidden_effects.hpp"

#include <gtest/gtest.h>

#include <set>

#include "parameters/parameter_error.hpp"
#include "tests/verification/pem/paper_case.hpp"

namespace railpem::simulate {
namespace {

/// What is needed beside the name for an effect to be complete.
std::string minimal(const HiddenEffect& effect) {
    std::string text = effect.id;
    char separator = ':';
    for (const HiddenParameter& p : effect.parameters) {
        if (!p.is_text) continue;
        text += separator + p.name + "=" +
                (p.name == "channel" ? "bogie_1"
                 : p.name == "stage" ? "primary"
                                     : "track.pads.damping_n_s_per_m");
        separator = ',';
    }
    if (effect.id == "failed-fasteners") text += ":every=4";
    return text;
}

TEST(HiddenEffects, EveryOneOfTheCatalogueAndAtLeastSixMore) {
    const std::set<std::string> catalogue{"pad-frequency-stiffening",
                                          "pad-preload-stiffening",
                                          "pad-hysteresis",
                                          "rail-shear",
                                          "support-compliance",
                                          "sleeper-flexibility",
                                          "rail-damper",
                                          "failed-fasteners",
                                          "sleeper-passing",
                                          "wheel-out-of-roundness",
                                          "rail-corrugation",
                                          "rail-joints",
                                          "irregularity-spectrum",
                                          "body-bending",
                                          "wheelset-bending",
                                          "bogie-mounted-mass",
                                          "primary-damper-series-stiffness",
                                          "secondary-damper-series-stiffness",
                                          "suspension-friction",
                                          "contact-nonlinearity",
                                          "contact-filter",
                                          "sensor-gain",
                                          "sensor-resonance",
                                          "sensor-noise",
                                          "timing-skew",
                                          "parameter-error"};
    std::set<std::string> here;
    std::set<std::string> extra;
    std::set<std::string> places;
    for (const HiddenEffect& effect : hidden_effects()) {
        (effect.only_here ? extra : here).insert(effect.id);
        if (effect.only_here) places.insert(effect.place);
    }
    EXPECT_EQ(here, catalogue);
    EXPECT_GE(extra.size(), 6u);
    EXPECT_GE(places.size(), 6u);
    for (const std::string& id : extra) EXPECT_NE(describe_hidden().find(id), std::string::npos);
    for (const std::string& id : catalogue) EXPECT_EQ(describe_hidden().find("`" + id + "`"), std::string::npos);
}

TEST(HiddenEffects, StandardStrengthsGiveValidCases) {
    const ScaleParameter scale = [](pem::CaseParameters& c, const std::string& key, double factor) {
        EXPECT_EQ(key, "track.pads.damping_n_s_per_m");
        c.track.pads.damping_n_s_per_m *= factor;
    };
    for (const HiddenEffect& effect : hidden_effects()) {
        auto c = tests::paper_case(1);
        if (effect.id == "sleeper-flexibility")
            c.track.support = {.model = track::SupportModel::two_layer, .mass_kg = 150, .stiffness_n_per_m = 8e7};
        OnlyHereParameters extra;
        const Hidden hidden = parse_hidden(minimal(effect));
        apply_hidden(hidden, c, extra, scale);
        EXPECT_NO_THROW(pem::check(c)) << effect.id;
        EXPECT_FALSE(hidden.forced);
        EXPECT_NE(hidden_json(hidden).find("\"effect\": \"" + effect.id + "\""), std::string::npos);
        for (const HiddenParameter& p : effect.parameters)
            EXPECT_TRUE(p.is_text || p.standard == 0.0 || (p.standard >= p.low && p.standard <= p.high))
                << effect.id << " " << p.name;
    }
}

TEST(HiddenEffects, ReadsValues) {
    const Hidden hidden = parse_hidden("rail-corrugation:wavelength_m=0.25,rms_m=2e-5");
    EXPECT_EQ(hidden.values.numbers.at("wavelength_m"), 0.25);
    EXPECT_EQ(hidden.values.numbers.at("rms_m"), 2e-5);
    EXPECT_EQ(hidden.values.numbers.at("relative_bandwidth"), 0.05);
    EXPECT_TRUE(hidden.values.has("rms_m"));
    EXPECT_FALSE(hidden.values.has("relative_bandwidth"));
    auto c = tests::paper_case(1);
    OnlyHereParameters extra;
    apply_hidden(parse_hidden("pad-hysteresis:loss_factor=0.4"), c, extra);
    EXPECT_EQ(c.track.pads.loss_factor, 0.4);
    apply_hidden(parse_hidden("axle-absorber:mass_kg=60,wheel=3"), c, extra);
    EXPECT_EQ(extra.axle_absorber.mass_kg, 60.0);
    EXPECT_EQ(extra.axle_absorber.wheel, 3);
}

/// The message of the refusal.
std::string refusal(const std::string& text) {
    try {
        parse_hidden(text);
    } catch (const parameters::ParameterError& error) {
        return error.what();
    }
    return "";
}

TEST(HiddenEffects, RefusesWithTheNearestName) {
    EXPECT_NE(refusal("pad-hysteresys").find("did you mean pad-hysteresis?"), std::string::npos);
    EXPECT_NE(refusal("rail-shear:shear_coeficient=0.4").find("did you mean shear_coefficient?"), std::string::npos);
    EXPECT_NE(refusal("rail-shear:shear_coefficient=0.6").find("between 0.34 and 0.41"), std::string::npos);
    EXPECT_NE(refusal("rail-shear:shear_coefficient=much").find("is not a number"), std::string::npos);
    EXPECT_NE(refusal("rail-shear:shear_coefficient").find("no value"), std::string::npos);
    EXPECT_NE(refusal("rail-shear:shear_coefficient=nan").find("is not a number"), std::string::npos);
    EXPECT_NE(refusal("sensor-gain:gain=2").find("channel"), std::string::npos);
    EXPECT_NE(refusal("sensor-gain:channel=boggie_1").find("did you mean bogie_1?"), std::string::npos);
    EXPECT_NE(refusal("rail-shear:shear_coefficient=0.35,shear_coefficient=0.4").find("twice"), std::string::npos);
    const Hidden forced = parse_hidden("rail-shear:shear_coefficient=0.6", true);
    EXPECT_TRUE(forced.forced);
    EXPECT_NE(hidden_json(forced).find("\"forced\": true"), std::string::npos);
}

TEST(HiddenEffects, RefusesWhatOnlyTheCaseCanTell) {
    auto c = tests::paper_case(1);
    OnlyHereParameters extra;
    EXPECT_THROW(apply_hidden(parse_hidden("failed-fasteners"), c, extra), parameters::ParameterError);
    EXPECT_THROW(apply_hidden(parse_hidden("suspension-friction:stage=tertiary"), c, extra),
                 parameters::ParameterError);
    EXPECT_THROW(apply_hidden(parse_hidden("parameter-error:parameter=track.spacing_m"), c, extra),
                 parameters::ParameterError);
}

}  // namespace
}  // namespace railpem::simulate
