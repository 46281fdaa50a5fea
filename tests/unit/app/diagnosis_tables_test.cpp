#include "app/tables/diagnosis_tables.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "diagnosis_fixtures.hpp"

namespace railpem::app {
namespace {

using diagnosis::Diagnosis;

std::string text_of(const Diagnosis& diagnosis, const std::string& name) {
    for (const TextFile& file : diagnosis_tables(diagnosis))
        if (file.name == name) return file.text;
    ADD_FAILURE() << "no " << name;
    return "";
}

std::vector<std::string> lines(const std::string& text) {
    std::vector<std::string> out;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) out.push_back(line);
    return out;
}

TEST(DiagnosisTables, FilesOfEveryRecording) {
    std::vector<std::string> names;
    for (const TextFile& file : diagnosis_tables(testing::explained())) names.push_back(file.name);
    EXPECT_EQ(names, (std::vector<std::string>{"run_60.spectra.csv", "run_60.bands.csv", "run_80.spectra.csv",
                                               "run_80.bands.csv", "parameters.csv", "curves.csv"}));
}

TEST(DiagnosisTables, SpectraHaveTheirUnitsAndEveryBin) {
    const auto rows = lines(text_of(testing::ambiguous(), "run_80.spectra.csv"));
    EXPECT_EQ(rows[0],
              "frequency_hz,channel,measured_psd_m2_per_s4_per_hz,low_psd_m2_per_s4_per_hz,high_psd_m2_per_s4_per_hz,"
              "believed_psd_m2_per_s4_per_hz,retuned_psd_m2_per_s4_per_hz,diagnosed_psd_m2_per_s4_per_hz");
    EXPECT_EQ(rows.size(), 1u + 9u * 800u);
    EXPECT_EQ(rows[1].substr(0, 15), "0.25,axlebox_1,");
    for (const std::string& row : rows) ASSERT_EQ(std::count(row.begin(), row.end(), ','), 7) << row;
}

TEST(DiagnosisTables, TextsAreQuotedWhereTheyMustBe) {
    EXPECT_NE(text_of(testing::explained(), "run_60.bands.csv").find("\n1,\"bogie_<b>&\"\"2\"\"\","),
              std::string::npos);
}

TEST(DiagnosisTables, WhatDoesNotExistIsAnEmptyCell) {
    for (const Diagnosis& diagnosis : {testing::consistent(), testing::recording_fault()})
        for (const TextFile& file : diagnosis_tables(diagnosis)) {
            EXPECT_EQ(file.text.find("nan"), std::string::npos) << file.name;
            EXPECT_EQ(file.text.find("inf"), std::string::npos) << file.name;
        }
    const auto rows = lines(text_of(testing::consistent(), "run_60.spectra.csv"));
    EXPECT_EQ(rows[1].back(), ',') << "the diagnosed case is the retuned one";
    EXPECT_NE(text_of(testing::explained(), "run_60.bands.csv").find(",body_centre,,,"), std::string::npos);
}

TEST(DiagnosisTables, NamesOfRecordingsBecomeNamesOfFiles) {
    Diagnosis diagnosis = testing::consistent();
    for (auto& channel : diagnosis.channels) channel.recording = channel.recording == "run_60" ? "../a b" : "..?a:b";
    std::vector<std::string> names;
    for (const TextFile& file : diagnosis_tables(diagnosis)) names.push_back(file.name);
    EXPECT_EQ(names[0], "_._a_b.spectra.csv");
    EXPECT_EQ(names[2], "_._a_b_2.spectra.csv");
}

TEST(DiagnosisTables, ParametersOfBothFitsAndTheCurve) {
    const auto parameters = lines(text_of(testing::explained(), "parameters.csv"));
    EXPECT_EQ(parameters.size(), 1u + 5u + 5u);
    EXPECT_EQ(parameters[1].substr(0, 49), "retuned,track.pads.stiffness_n_per_m,N/m,90000000");
    EXPECT_EQ(parameters[1].back(), '1') << "outside its tolerance";
    EXPECT_EQ(parameters[6].substr(0, 10), "diagnosed,");
    const auto curves = lines(text_of(testing::explained(), "curves.csv"));
    EXPECT_EQ(curves.size(), 1u + 25u);
    EXPECT_EQ(curves[1].substr(0, 11), "pad,N/m,10,");
}

}  // namespace
}  // namespace railpem::app
