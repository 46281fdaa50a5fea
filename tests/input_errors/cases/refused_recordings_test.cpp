// Recordings that `diagnose` cannot hold against a case, each with its reason.

#include <gtest/gtest.h>

#include "program_run.hpp"

namespace railpem::tests {
namespace {

/// Runs `diagnose` on a spectrum recording; returns the outcome, having checked that nothing was left behind.
Outcome diagnosed(const ProgramFolder& folder, const std::string& recording, const std::string& data) {
    folder.write("case.toml", minimal_case());
    folder.write("psd.toml", recording);
    folder.write("data.csv", data);
    const Outcome outcome = folder.run({"diagnose", "case.toml", "psd.toml", "--out", "results"});
    EXPECT_EQ(folder.content(), (std::vector<std::string>{"case.toml", "data.csv", "psd.toml"}));
    EXPECT_EQ(outcome.status, 2);
    return outcome;
}

bool says(const Outcome& outcome, const std::string& what) {
    return outcome.message.find(what) != std::string::npos;
}

constexpr const char* kWheel = "[[channel]]\nname = \"w\"\nlocation = \"wheel\"\nindex = 1\n";
constexpr const char* kSpectrum = "frequency_hz,w\n10,1.0\n20,2.0\n30,1.5\n";

TEST(RefusedRecordings, ChannelsThatTheCaseDoesNotHave) {
    const ProgramFolder folder;
    const Outcome outcome = diagnosed(folder,
                                      "kind = \"psd\"\ndata = \"data.csv\"\nspeed_m_per_s = 20.0\n[[channel]]\nname = "
                                      "\"w\"\nlocation = \"body\"\nposition_m = 4.0\n",
                                      kSpectrum);
    EXPECT_TRUE(says(outcome, "none of the channels is a response that the case has")) << outcome.message;
    EXPECT_TRUE(says(outcome, "allowed: channels on body centre, body over the pivots, bogies, wheels or rail"))
        << outcome.message;
}

TEST(RefusedRecordings, SpectraWithoutASpeed) {
    for (const char* kind : {"psd", "points"}) {
        const ProgramFolder folder;
        const std::string data =
            std::string(kind) == "psd" ? kSpectrum : "channel,frequency_hz,value\nw,10,1.0\nw,20,2.0\n";
        const Outcome outcome =
            diagnosed(folder, std::string("kind = \"") + kind + "\"\ndata = \"data.csv\"\n" + kWheel, data);
        EXPECT_TRUE(says(outcome, "channels of a running train without its speed")) << outcome.message;
    }
}

TEST(RefusedRecordings, SpeedOutsideTheBandOfTheIrregularity) {
    const ProgramFolder folder;  // waves of 1 m and more at 1 m/s excite up to 1 Hz
    const Outcome outcome = diagnosed(
        folder, std::string("kind = \"psd\"\ndata = \"data.csv\"\nspeed_m_per_s = 1.0\n") + kWheel, kSpectrum);
    EXPECT_TRUE(says(outcome, "at 1 m/s no value lies in the usable band")) << outcome.message;
}

TEST(RefusedRecordings, NothingButZeros) {
    const ProgramFolder folder;
    const Outcome outcome = diagnosed(folder, "kind = \"decay-rate\"\ndata = \"data.csv\"\n",
                                      "centre_hz,decay_rate_db_per_m\n100,0\n125,0\n");
    EXPECT_TRUE(says(outcome, "no value is greater than zero")) << outcome.message;
}

TEST(RefusedRecordings, SameEvidenceTwice) {
    const ProgramFolder folder;
    folder.write("case.toml", minimal_case());
    folder.write("psd.toml", std::string("kind = \"psd\"\ndata = \"data.csv\"\nspeed_m_per_s = 20.0\n") + kWheel);
    std::string spectrum = "frequency_hz,w\n";  // within the band that the case's irregularity excites at 20 m/s
    for (int i = 0; i < 40; ++i) spectrum += std::to_string(3.0 + 0.3 * i) + ",1.0\n";
    folder.write("data.csv", spectrum);
    const Outcome twice = folder.run({"diagnose", "case.toml", "psd.toml", "./psd.toml", "--out", "results"});
    EXPECT_EQ(twice.status, 2);
    EXPECT_TRUE(says(twice, "the same recording twice")) << twice.message;
    folder.write("copy.toml", std::string("kind = \"psd\"\ndata = \"data.csv\"\nspeed_m_per_s = 20.0\n") + kWheel);
    const Outcome copy = folder.run({"diagnose", "case.toml", "psd.toml", "copy.toml", "--out", "results"});
    EXPECT_EQ(copy.status, 2);
    EXPECT_TRUE(says(copy, "the same data file twice")) << copy.message;
}

TEST(RefusedRecordings, EffectThatTheCatalogueDoesNotHave) {
    const ProgramFolder folder;
    folder.write("case.toml", minimal_case());
    const Outcome outcome =
        folder.run({"diagnose", "case.toml", "psd.toml", "--without", "body-bendin", "--out", "results"});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_TRUE(says(outcome, "unknown effect 'body-bendin'")) << outcome.message;
    EXPECT_TRUE(says(outcome, "did you mean 'body-bending'?")) << outcome.message;
}

}  // namespace
}  // namespace railpem::tests
