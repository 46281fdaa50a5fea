// Every way to ask for a world or a speed that cannot be, with the whole message that the user sees.

#include <gtest/gtest.h>

#include "program_run.hpp"

namespace railpem::tests {
namespace {

/// Refused with status 2 and this message (its beginning, when it does not end in a line), and nothing is written.
void expect_world_refused(const std::vector<std::string>& options, const std::string& message,
                          const std::string& speeds = "") {
    const ProgramFolder folder;
    folder.write("case.toml", minimal_case());
    folder.write("speeds.csv", speeds);
    std::vector<std::string> arguments{"simulate", "case.toml", "--seconds", "60", "--seed", "1", "--out", "run"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = folder.run(arguments);
    EXPECT_EQ(outcome.status, 2);
    if (message.ends_with("\n"))
        EXPECT_EQ(outcome.message, message);
    else
        EXPECT_TRUE(outcome.message.starts_with(message)) << outcome.message;
    EXPECT_EQ(folder.content(), (std::vector<std::string>{"case.toml", "speeds.csv"}));
}

TEST(RefusedWorlds, UnknownGrade) {
    expect_world_refused({"--world", "goood"},
                         "--world goood: unknown grade 'goood'\nallowed: ideal, good, worn\ndid you mean 'good'?\n");
}

TEST(RefusedWorlds, UnknownNumber) {
    const ProgramFolder folder;
    folder.write("case.toml", minimal_case());
    const Outcome outcome = folder.run(
        {"simulate", "case.toml", "--seconds", "60", "--seed", "1", "--out", "run", "--world", "good:speed_rsm=0.004"});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_TRUE(
        outcome.message.starts_with("--world good:speed_rsm=0.004: unknown number of a world 'speed_rsm'\n"
                                    "allowed: speed_rms, speed_correlation_s, "))
        << outcome.message;
    EXPECT_TRUE(outcome.message.ends_with("\ndid you mean 'speed_rms'?\n")) << outcome.message;
}

TEST(RefusedWorlds, ValuesOutOfRange) {
    expect_world_refused({"--world", "worn:pad_scatter=-0.1"},
                         "--world worn:pad_scatter=-0.1: 'pad_scatter' cannot be -0.1\nallowed: between 0 and 1\n");
    expect_world_refused({"--world", "worn:tone_hz=nan"},
                         "--world worn:tone_hz=nan: 'tone_hz' cannot be nan\nallowed: between 0.1 and 50000 Hz\n");
    expect_world_refused({"--world", "worn:tone_hz=fast"},
                         "--world worn:tone_hz=fast: 'tone_hz' cannot be fast\nallowed: between 0.1 and 50000 Hz\n");
}

TEST(RefusedWorlds, MissingAndRepeatedValues) {
    expect_world_refused({"--world", "good:speed_rms"},
                         "--world good:speed_rms: 'speed_rms' has no value\nallowed: speed_rms=VALUE\n");
    expect_world_refused({"--world", "good:speed_rms=0.01,speed_rms=0.02"},
                         "--world good:speed_rms=0.01,speed_rms=0.02: 'speed_rms' is given twice\nallowed: once\n");
}

TEST(RefusedWorlds, SpeedProfiles) {
    const std::vector<std::string> option{"--speed-profile", "speeds.csv"};
    expect_world_refused(option,
                         "--speed-profile speeds.csv: time 3 is missing or out of order\nallowed: increasing times\n",
                         "time_s,speed_m_per_s\n0,20\n10,20\n10,30\n");
    expect_world_refused(option,
                         "--speed-profile speeds.csv: speed 2 cannot be -1 m/s\nallowed: between 0 and 200 m/s\n",
                         "time_s,speed_m_per_s\n0,20\n10,-1\n");
    expect_world_refused(option,
                         "--speed-profile speeds.csv: the train never moves\nallowed: two rows or more, one speed of "
                         "which is greater than 0\n",
                         "time_s,speed_m_per_s\n0,0\n10,0\n");
    expect_world_refused(
        {"--speed-profile", "speeds.csv", "--speed", "20"},
        "--speed-profile: the speed is given by --speed already\nallowed: --speed or --speed-profile\n",
        "time_s,speed_m_per_s\n0,20\n10,30\n");
    expect_world_refused({"--speed-profile", "speeds.csv", "--world", "ideal:speed_end_m_per_s=30"},
                         "--world: 'speed_end_m_per_s' is a ramp from a constant speed\nallowed: speed_end_m_per_s or "
                         "--speed-profile\n",
                         "time_s,speed_m_per_s\n0,20\n10,30\n");
    expect_world_refused(option, "speeds.csv:1: there is no column 'speed_m_per_s'", "time_s,speed\n0,20\n10,30\n");
}

TEST(RefusedWorlds, OfAProof) {
    const ProgramFolder folder;
    const Outcome outcome = folder.run({"prove", "--quick", "--out", "out", "--world", "perfect"});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.message, "--world perfect: unknown grade 'perfect'\nallowed: ideal, good, worn\n");
    EXPECT_TRUE(folder.content().empty());
}

}  // namespace
}  // namespace railpem::tests
