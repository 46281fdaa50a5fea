// `railpem compare`: sign, bands, speeds.

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/tables/level_differences.hpp"
#include "pem/response_names.hpp"
#include "program_in_process.hpp"

namespace railpem::app {
namespace {

ResponseSpectra flat(double psd, double from_hz, double to_hz) {
    ResponseSpectra spectra{.speed_m_per_s = 20.0};
    for (double f = from_hz; f <= to_hz; f += 0.5) spectra.frequency_hz.push_back(f);
    spectra.psd.assign(pem::response_names().size(), std::vector<double>(spectra.frequency_hz.size(), psd));
    return spectra;
}

TEST(LevelDifferences, PositiveWhereTheSecondCaseHasMore) {
    const LevelDifferences twice = level_differences(flat(1.0, 5.0, 100.0), flat(2.0, 5.0, 100.0));
    for (const std::vector<double>& response : twice.difference_db)
        for (const double difference : response) EXPECT_NEAR(difference, 10.0 * std::log10(2.0), 1e-12);
    const LevelDifferences back = level_differences(flat(2.0, 5.0, 100.0), flat(1.0, 5.0, 100.0));
    EXPECT_NEAR(back.difference_db[0][0], -10.0 * std::log10(2.0), 1e-12);
}

TEST(LevelDifferences, OnlyBandsThatBothCasesCover) {
    const LevelDifferences common = level_differences(flat(1.0, 5.0, 100.0), flat(1.0, 8.5, 60.0));
    ASSERT_FALSE(common.centre_hz.empty());
    EXPECT_EQ(common.centre_hz.front(), 10.0);  // from 8.91 Hz
    EXPECT_EQ(common.centre_hz.back(), 50.0);   // to 56.2 Hz; the band of 63 Hz ends at 70.8 Hz
    EXPECT_EQ(common.difference_db[17].size(), common.centre_hz.size());
}

TEST(LevelDifferences, BandsAtRestInBothCasesAreLeftOut) {
    EXPECT_TRUE(level_differences(flat(0.0, 5.0, 100.0), flat(0.0, 5.0, 100.0)).centre_hz.empty());
    EXPECT_EQ(level_differences(flat(1.0, 5.0, 100.0), flat(0.0, 5.0, 100.0)).difference_db[0][0], -INFINITY);
}

/// A rougher track by 6 dB is 6 dB in every response and band: the model is linear.
TEST(Compare, LinearInTheIrregularity) {
    const Scratch scratch;
    const std::string text = scratch.read(shipped("wei2016/case2.toml"));  // an absolute path stays one
    scratch.write("quiet.toml", text);
    std::string rough = text;
    rough.insert(rough.find("[[irregularity.band]]"), "[irregularity]\nlevel_db = 6.0\n\n");
    scratch.write("rough.toml", rough);
    ASSERT_EQ(
        run({"compare", scratch.path("quiet.toml"), scratch.path("rough.toml"), "--out", scratch.path("out")}).status,
        0);
    const auto table = columns(scratch.read("out/quiet-rough.compare.csv"));
    EXPECT_EQ(table.size(), 1u + pem::response_names().size());
    EXPECT_GT(table.at("centre_hz").size(), 20u);
    for (const char* name : {"wheel_1_acceleration_level_difference_db", "contact_3_force_level_difference_db",
                             "trackbed_force_insertion_gain_db"})
        for (const double difference : table.at(name))
            EXPECT_NEAR(difference, 6.0, 1e-7) << name;  // nine digits in the table
    const nlohmann::json summary = nlohmann::json::parse(scratch.read("out/quiet-rough.compare.json"));
    EXPECT_EQ(summary["case_1"], "quiet");
    EXPECT_EQ(summary["sign"], "positive where case_2 has more");
    EXPECT_NEAR(summary["speeds"][0]["force"]["trackbed"]["rms_difference_db"].get<double>(), 6.0, 1e-9);
    EXPECT_NEAR(summary["speeds"][0]["acceleration"]["body"]["largest_difference_db"].get<double>(), 6.0, 1e-9);
}

TEST(Compare, SpeedsPairwiseOrOneEach) {
    const Scratch scratch;
    std::string text = scratch.read(shipped("wei2016/case1.toml"));
    const auto with_speeds = [&](const std::string& speeds) {
        const std::size_t begin = text.find("speeds_m_per_s = "), end = text.find('\n', begin);
        return text.substr(0, begin) + "speeds_m_per_s = " + speeds + text.substr(end);
    };
    scratch.write("slow.toml", with_speeds("20.0"));
    scratch.write("fast.toml", with_speeds("30.0"));
    scratch.write("both.toml", with_speeds("[20.0, 30.0]"));
    ASSERT_EQ(
        run({"compare", scratch.path("slow.toml"), scratch.path("fast.toml"), "--out", scratch.path("out")}).status, 0);
    ASSERT_EQ(
        run({"compare", scratch.path("both.toml"), scratch.path("both.toml"), "--out", scratch.path("out")}).status, 0);
    const auto table = columns(scratch.read("out/both-both.compare.csv"));
    EXPECT_EQ(table.at("speed_m_per_s").front(), 20.0);
    EXPECT_EQ(table.at("speed_m_per_s").back(), 30.0);
    for (const double difference : table.at("trackbed_force_insertion_gain_db")) EXPECT_EQ(difference, 0.0);
    const ProgramResult refused =
        run({"compare", scratch.path("slow.toml"), scratch.path("both.toml"), "--out", scratch.path("other")});
    EXPECT_EQ(refused.status, 2);
    EXPECT_EQ(refused.message, "railpem compare: running.speeds_m_per_s is [20] in " + scratch.path("slow.toml") +
                                   " and [20, 30] in " + scratch.path("both.toml") +
                                   "\nallowed: one speed in each, or the same list in both\n");
    EXPECT_FALSE(scratch.has("other"));
}

TEST(Compare, TwoCasesAreNeeded) {
    const Scratch scratch;
    EXPECT_EQ(run({"compare", shipped("wei2016/case1.toml"), "--out", scratch.path("out")}).status, 2);
    EXPECT_FALSE(scratch.has("out"));
}

}  // namespace
}  // namespace railpem::app
