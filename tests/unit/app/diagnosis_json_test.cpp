#include "app/tables/diagnosis_json.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "diagnosis_fixtures.hpp"

namespace railpem::app {
namespace {

using Json = nlohmann::json;
using diagnosis::Diagnosis;

Json written(const Diagnosis& diagnosis) {
    return Json::parse(diagnosis_json(diagnosis));
}

/// Kinds of the contract's values: "s" text, "n" number or null, "a" array, "o" object, "p" probability.
void expect_kinds(const Json& json, const std::map<std::string, char>& kinds, const std::string& where) {
    ASSERT_TRUE(json.is_object()) << where;
    for (const auto& [key, kind] : kinds) {
        ASSERT_TRUE(json.contains(key)) << where << "." << key;
        const Json& value = json[key];
        switch (kind) {
            case 's':
                EXPECT_TRUE(value.is_string()) << where << "." << key;
                break;
            case 'n':
                EXPECT_TRUE(value.is_number() || value.is_null()) << where << "." << key;
                break;
            case 'p':
                EXPECT_TRUE(value.is_number() && value >= 0.0 && value <= 1.0) << where << "." << key;
                break;
            case 'a':
                EXPECT_TRUE(value.is_array()) << where << "." << key;
                break;
            default:
                EXPECT_TRUE(value.is_object()) << where << "." << key;
        }
    }
}

TEST(DiagnosisJson, HasEveryKeyOfTheContractInEveryVerdict) {
    for (const Diagnosis& diagnosis : testing::every_verdict()) {
        const Json json = written(diagnosis);
        expect_kinds(json,
                     {{"verdict", 's'},
                      {"statement", 's'},
                      {"omitted", 'a'},
                      {"posterior", 'a'},
                      {"rivals", 'a'},
                      {"places", 'a'},
                      {"mismatch", 'a'},
                      {"fit", 'o'},
                      {"hidden_by_retuning", 'n'}},
                     "");
        for (const Json& effect : json["omitted"]) {
            expect_kinds(effect,
                         {{"effect", 's'}, {"probability", 'p'}, {"says", 's'}, {"parameters", 'o'}, {"source", 's'}},
                         "omitted");
            for (const Json& parameter : effect["parameters"]) {
                ASSERT_TRUE(parameter.contains("value"));
                if (parameter.size() > 1)
                    expect_kinds(parameter, {{"value", 'n'}, {"low", 'n'}, {"high", 'n'}, {"unit", 's'}}, "parameters");
            }
        }
        for (const Json& set : json["posterior"])
            expect_kinds(set, {{"effects", 'a'}, {"probability", 'p'}}, "posterior");
        for (const Json& rival : json["rivals"])
            expect_kinds(rival, {{"effects", 'a'}, {"probability", 'p'}, {"why_not", 's'}, {"would_separate", 's'}},
                         "rivals");
        for (const Json& place : json["places"])
            expect_kinds(place, {{"element", 's'}, {"probability", 'p'}}, "places");
        for (const Json& m : json["mismatch"])
            expect_kinds(m,
                         {{"channel", 's'},
                          {"low_hz", 'n'},
                          {"high_hz", 'n'},
                          {"level_db", 'n'},
                          {"false_alarm_probability", 'p'},
                          {"element", 's'}},
                         "mismatch");
        for (const char* fit : {"before", "retuned", "after", "held_out_before", "held_out_retuned", "held_out_after"})
            expect_kinds(json["fit"][fit], {{"rms_db", 'n'}, {"log_likelihood_per_second", 'n'}}, fit);
    }
}

TEST(DiagnosisJson, StartsWithTheKeysOfTheContractInItsOrder) {
    const auto json = nlohmann::ordered_json::parse(diagnosis_json(testing::explained()));
    std::vector<std::string> keys;
    for (const auto& [key, value] : json.items()) keys.push_back(key);
    keys.resize(9);
    EXPECT_EQ(keys, (std::vector<std::string>{"verdict", "statement", "omitted", "posterior", "rivals", "places",
                                              "mismatch", "fit", "hidden_by_retuning"}));
}

TEST(DiagnosisJson, VerdictsHaveTheirNames) {
    std::vector<std::string> names;
    for (const Diagnosis& diagnosis : testing::every_verdict()) names.push_back(written(diagnosis)["verdict"]);
    EXPECT_EQ(names,
              (std::vector<std::string>{"explained", "ambiguous", "consistent", "unexplained", "recording-fault"}));
}

TEST(DiagnosisJson, NothingIsOmittedWhereNothingIsNamed) {
    for (Diagnosis diagnosis : {testing::ambiguous(), testing::consistent()}) {
        diagnosis.omitted = testing::explained().omitted;  // a mistake upstream does not become a false name
        EXPECT_TRUE(written(diagnosis)["omitted"].empty());
    }
    EXPECT_EQ(written(testing::ambiguous())["rivals"].size(), 2u);
}

TEST(DiagnosisJson, AnEntryPerInstanceWithItsChoices) {
    const Json omitted = written(testing::recording_fault())["omitted"];
    ASSERT_EQ(omitted.size(), 2u);
    EXPECT_EQ(omitted[0]["parameters"]["channel"], (Json{{"value", "bogie_2"}}));
    EXPECT_EQ(omitted[1]["parameters"]["wheel"], (Json{{"value", 2}}));
    EXPECT_EQ(omitted[1]["parameters"]["order"], (Json{{"value", 3}}));
    EXPECT_TRUE(omitted[1]["parameters"]["amplitude_m"]["high"].is_null()) << "infinity is no number of JSON";
}

TEST(DiagnosisJson, NumbersAreReadBackBitByBit) {
    const Diagnosis diagnosis = testing::explained();
    const Json json = written(diagnosis);
    EXPECT_EQ(json["omitted"][0]["parameters"]["exponent"]["value"].get<double>(),
              diagnosis.omitted[0].parameters[0].value);
    EXPECT_EQ(json["curves"][0]["value"]["real"][7].get<double>(), diagnosis.curves[0].value[7].real());
    EXPECT_EQ(json["retuned_numbers"][1]["tolerances_away"].get<double>(),
              diagnosis.retuned_numbers[1].tolerances_away);
    EXPECT_EQ(json["mismatch"][2]["false_alarm_probability"].get<double>(), 3e-20);
}

TEST(DiagnosisJson, WhatDoesNotExistIsNull) {
    const std::string text = diagnosis_json(testing::consistent());
    const Json json = Json::parse(text);
    EXPECT_TRUE(json["hidden_by_retuning"].is_null());
    EXPECT_TRUE(json["fit"]["held_out_after"]["rms_db"].is_null());
    EXPECT_EQ(text.find("nan"), std::string::npos);
}

TEST(DiagnosisJson, WhatRetuningReachesThatNeedNotKeepItsBeliefs) {
    Diagnosis diagnosis = testing::explained();
    EXPECT_FALSE(written(diagnosis)["fit"].contains("freely_retuned")) << "the verdict is held against just that";
    diagnosis.freely_retuned = diagnosis::FreelyRetuned{.fitted = {0.42, -318.5}, .held_out = {0.93, 11.5}};
    const Json fit = written(diagnosis)["fit"];
    EXPECT_EQ(fit["freely_retuned"]["rms_db"], 0.42);
    EXPECT_EQ(fit["held_out_freely_retuned"]["log_likelihood_per_second"], 11.5);
    EXPECT_EQ(fit["retuned"]["rms_db"], diagnosis.retuned.rms_db);
}

TEST(DiagnosisJson, BytesThatAreNoTextDoNotStopIt) {
    Diagnosis diagnosis = testing::explained();
    diagnosis.recordings[0].name = "run\xff";
    EXPECT_TRUE(Json::accept(diagnosis_json(diagnosis)));
}

}  // namespace
}  // namespace railpem::app
