// `railpem simulate` through the program: what it writes, where the truth goes, equal bits, and what it refuses.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "program.hpp"

namespace railpem::tests {
namespace {

using nlohmann::json;

/// The shortest record that a lowest frequency of 1 Hz allows.
std::vector<std::string> simulation(const std::string& out, const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments{"simulate",  kCase, "--set", "frequency.from_hz=1",
                                       "--seconds", "2",   "--out", out};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

TEST(Simulate, EqualSeedsGiveEqualBitsInEveryFormat) {
    const Folder folder;
    for (const char* out : {"first", "second"}) {
        ASSERT_EQ(folder
                      .run(simulation(std::string(out) + "/mat", {"--seed", "7", "--format", "mat", "--noise", "0.02",
                                                                  "--truth", std::string(out) + "/truth.json"}))
                      .status,
                  0);
        ASSERT_EQ(
            folder.run(simulation(std::string(out) + "/h5", {"--seed", "7", "--format", "hdf5", "--noise", "0.02"}))
                .status,
            0);
    }
    const auto truth = [&](const char* file) {
        json own = json::parse(folder.read(file));
        own.erase("provenance");  // the command that made it
        return own;
    };
    EXPECT_EQ(truth("first/truth.json"), truth("second/truth.json"));
    for (const char* file : {"mat/recording.csv", "mat/recording.mat", "mat/recording.toml", "h5/recording.h5"}) {
        EXPECT_FALSE(folder.read(std::string("first/") + file).empty()) << file;
        EXPECT_TRUE(folder.read(std::string("first/") + file) == folder.read(std::string("second/") + file)) << file;
    }
    EXPECT_TRUE(folder.read("first/mat/recording.csv") == folder.read("first/h5/recording.csv"));
    for (const char* kind : {"mat", "h5"}) {
        const Outcome valid = folder.run({"validate", std::string("first/") + kind});
        EXPECT_EQ(valid.status, 0) << valid.message;
        EXPECT_EQ(valid.output, std::string("first/") + kind + ": a valid recording\n");
    }
}

TEST(Simulate, AnotherSeedIsAnotherTrack) {
    const Folder folder;
    ASSERT_EQ(folder.run(simulation("one", {"--seed", "1"})).status, 0);
    ASSERT_EQ(folder.run(simulation("two", {"--seed", "2"})).status, 0);
    ASSERT_EQ(
        folder.run(simulation("two_on_one", {"--seed", "2", "--profile-seed", "9", "--profile-length", "400"})).status,
        0);
    ASSERT_EQ(
        folder.run(simulation("one_on_one", {"--seed", "1", "--profile-seed", "9", "--profile-length", "400"})).status,
        0);
    EXPECT_TRUE(folder.read("one/recording.csv") != folder.read("two/recording.csv"));
    EXPECT_TRUE(folder.read("two_on_one/recording.csv") == folder.read("one_on_one/recording.csv"));
}

TEST(Simulate, TruthSaysAllAndStandsNowhereElse) {
    const Folder folder;
    const Outcome outcome = folder.run(simulation(
        "out", {"--seed", "3", "--truth", "kept/truth.json", "--standing", "--rate", "500", "--speed", "15", "--hide",
                "rail-shear", "--hide", "sensor-gain:channel=bogie_2,gain=1.3", "--hide", "axle-absorber:mass_kg=500",
                "--hide", "parameter-error:parameter=vehicle.body_mass_kg,factor=1.2", "--force"}));
    ASSERT_EQ(outcome.status, 0) << outcome.message;
    EXPECT_EQ(outcome.output + outcome.message, "");
    EXPECT_EQ(folder.content(),
              (std::vector<std::string>{"kept", "kept/truth.json", "out", "out/recording.csv", "out/recording.toml"}));
    const json truth = json::parse(folder.read("kept/truth.json"));
    EXPECT_EQ(truth.at("case"), kCase);
    EXPECT_EQ(truth.at("set"), json({"frequency.from_hz=1"}));
    EXPECT_EQ(truth.at("seed"), 3);
    EXPECT_EQ(truth.at("wheels"), "standing");
    EXPECT_EQ(truth.at("speed_m_per_s"), 15.0);
    EXPECT_EQ(truth.at("sampling_rate_hz"), 500.0);
    EXPECT_TRUE(truth.at("forced"));
    const json& effects = truth.at("effects");
    ASSERT_EQ(effects.size(), 4u);
    EXPECT_EQ(effects[0].at("effect"), "rail-shear");
    EXPECT_FALSE(effects[0].at("forced"));
    EXPECT_GE(effects[0].at("parameters").at("shear_coefficient"), 0.34);  // the default is written out
    EXPECT_EQ(effects[1].at("parameters"), json({{"channel", "bogie_2"}, {"gain", 1.3}}));
    EXPECT_EQ(effects[2].at("parameters").at("mass_kg"), 500.0);  // beyond 300 kg
    EXPECT_TRUE(effects[2].at("forced"));
    EXPECT_TRUE(effects[2].at("only_here"));
    EXPECT_NE(truth.at("true_case").get<std::string>().find("body_mass_kg = 46200\n"),
              std::string::npos);  // 1.2 · 38500
    const std::string description = folder.read("out/recording.toml");
    for (const char* word : {"shear", "gain", "absorber", "seed", "body_mass", "hide"})
        EXPECT_EQ(description.find(word), std::string::npos) << word;
    const std::string samples = folder.read("out/recording.csv");
    EXPECT_EQ(samples.substr(0, samples.find('\n')),
              "time_s,axlebox_1,axlebox_2,axlebox_3,axlebox_4,bogie_1,bogie_2,body_front,body_rear,body_centre");
    EXPECT_EQ(std::count(samples.begin(), samples.end(), '\n'), 1002);  // 2 s at 500 Hz between header and comment
}

TEST(Simulate, ListNamesWhatDiagnoseKnowsAndWhatItDoesNot) {
    const Folder folder;
    const Outcome outcome = folder.run({"simulate", "--list"});
    ASSERT_EQ(outcome.status, 0);
    const std::size_t only_here = outcome.output.find("Effects that exist only in simulate");
    ASSERT_NE(only_here, std::string::npos);
    EXPECT_LT(outcome.output.find("\npad-frequency-stiffening (pad): "), only_here);
    for (const char* name : {"\nbogie-coupling (", "\naxle-absorber (", "\npad-dead-band (", "\nguidance-stick-slip (",
                             "\nbody-coupling ("}) {
        const std::size_t at = outcome.output.find(name);
        EXPECT_NE(at, std::string::npos) << name;
        EXPECT_GT(at, only_here) << name;
    }
    EXPECT_NE(outcome.output.find("0.02 to 0.35, default 0.15"), std::string::npos);
}

struct Refusal {
    std::vector<std::string> arguments;
    std::string message;
};

const std::string kChannels =
    "axlebox_1, axlebox_2, axlebox_3, axlebox_4, bogie_1, bogie_2, body_front, body_rear, body_centre";

const std::vector<Refusal> kRefusals{
    {{"--seed", "1", "--set", "frequency.from_hz=0.5"},
     "--seconds: 2 s is too short for a single average at 0.5 Hz, the case's lowest frequency\nallowed: at least 4 "
     "s\n"},
    {{"--seed", "1", "--rate", "399"},
     "--rate: 399 Hz cannot show the case's highest frequency, 200 Hz\nallowed: at least 400 Hz\n"},
    {{"--seed", "1", "--rate", "1e9"}, "--rate: cannot be 1e+09 Hz\nallowed: greater than 0, at most 100000 Hz\n"},
    {{"--seed", "-1"}, "--seed: cannot be -1\nallowed: a whole number of at least 0\n"},
    {{},
     "railpem simulate: --seed is required\nallowed: --seed N, which draws track and noise; railpem simulate --help "
     "says more\n"},
    {{"--seed", "1", "--speed=-3"}, "--speed: cannot be -3 m/s\nallowed: greater than 0, at most 200 m/s\n"},
    {{"--seed", "1", "--noise", "nan"}, "--noise: cannot be nan m/s^2\nallowed: between 0 and 1000 m/s^2\n"},
    {{"--seed", "1", "--hide", "rail-sheer:shear_coefficient=0.4"},
     "--hide rail-sheer:shear_coefficient=0.4: unknown effect 'rail-sheer'\nallowed: pad-frequency-stiffening, "},
    {{"--seed", "1", "--hide", "rail-shear:shear_coeficient=0.4"},
     "--hide rail-shear:shear_coeficient=0.4: unknown parameter 'shear_coeficient'\nallowed: shear_coefficient\ndid "
     "you mean 'shear_coefficient'?\n"},
    {{"--seed", "1", "--hide", "rail-shear:shear_coefficient=0.9"},
     "--hide rail-shear:shear_coefficient: 0.9 is outside the physical range\nallowed: between 0.34 and 0.41, or "
     "--force\n"},
    {{"--seed", "1", "--force", "--hide", "rail-shear:shear_coefficient=inf"},
     "--hide rail-shear:shear_coefficient: \"inf\" is not a number\nallowed: a number\n"},
    {{"--seed", "1", "--hide", "timing-skew:channel=axlebox_5"},
     "--hide timing-skew:channel: no channel \"axlebox_5\"\nallowed: " + kChannels + " (did you mean axlebox_1?)\n"},
    {{"--seed", "1", "--hide", "parameter-error:parameter=vehicle.body_mas_kg"},
     "--hide parameter-error:parameter=vehicle.body_mas_kg: the case has no such number\nallowed: a dotted key of a "
     "number; railpem describe case lists them\ndid you mean 'vehicle.body_mass_kg'?\n"},
    {{"--seed", "1", "--truth", "out/recording.csv"},
     "--truth out/recording.csv: would overwrite the recording\nallowed: another file\n"},
    {{"--seed", "1", "--profile-length", "3", "--profile-seed", "1"}, "--profile-length: 3 m of profile for "},
};

/// CSV of a profile with waves 5 m long, from `from_m` on for 800 m.
std::string waves(double from_m, double amplitude_m) {
    std::string text = "position_m,height_m\n";
    for (int i = 0; i <= 16000; ++i) {
        const double x = from_m + 0.05 * i;
        text +=
            std::to_string(x) + "," + std::to_string(amplitude_m * std::sin(2.0 * std::numbers::pi * x / 5.0)) + "\n";
    }
    return text;
}

double rms_of_column(const std::string& csv, int column) {
    std::istringstream lines(csv);
    std::string line, cell;
    std::getline(lines, line);
    double sum = 0.0;
    int rows = 0;
    for (; std::getline(lines, line) && !line.starts_with('#'); ++rows) {
        std::istringstream cells(line);
        for (int i = 0; i <= column; ++i) std::getline(cells, cell, ',');
        sum += std::stod(cell) * std::stod(cell);
    }
    return std::sqrt(sum / rows);
}

// A wheel follows waves of 4.4 Hz: a·ω²/√2. Far below the resonance of the wheels on the track, at some 40 Hz; what
// passing sleepers add at the axle box is 1 % of that, the resonance another 1 %.
TEST(Simulate, WheelsFollowAMeasuredProfile) {
    const Folder folder;
    folder.write("profile.csv", waves(-250.0, 2e-3));
    ASSERT_EQ(folder.run(simulation("out", {"--seed", "1", "--profile", "profile.csv"})).status, 0);
    const double omega = 2.0 * std::numbers::pi * (80.0 / 3.6) / 5.0;
    EXPECT_NEAR(rms_of_column(folder.read("out/recording.csv"), 1), 2e-3 * omega * omega / std::numbers::sqrt2, 0.06);
}

TEST(Simulate, ProfilesThatCannotBe) {
    const Folder folder;
    folder.write("order.csv", "position_m,height_m\n0,0\n1,1e-4\n1,2e-4\n");
    folder.write("short.csv", waves(0.0, 1e-3));
    const Outcome disordered = folder.run(simulation("out", {"--seed", "1", "--profile", "order.csv"}));
    EXPECT_EQ(disordered.status, 2);
    EXPECT_EQ(disordered.message,
              "--profile order.csv: value 3 of position_m is missing or out of order\nallowed: increasing positions, "
              "every height known\n");
    const Outcome too_short = folder.run(simulation("out", {"--seed", "1", "--profile", "short.csv"}));
    EXPECT_EQ(too_short.status, 2);
    EXPECT_TRUE(too_short.message.starts_with("--profile: the measured profile does not cover -")) << too_short.message;
    EXPECT_EQ(folder.run(simulation("out", {"--seed", "1", "--profile", "none.csv"})).status, 2);
    EXPECT_FALSE(folder.has("out"));
}

/// Refused with the whole message, and nothing is left behind: not even the folder of the truth.
TEST(Simulate, Refusals) {
    for (const Refusal& refusal : kRefusals) {
        const Folder folder;
        std::vector<std::string> arguments = simulation("out", refusal.arguments);
        if (std::find(arguments.begin(), arguments.end(), "--truth") == arguments.end())
            arguments.insert(arguments.end(), {"--truth", "kept/truth.json"});
        const Outcome outcome = folder.run(arguments);
        EXPECT_EQ(outcome.status, 2) << refusal.message;
        if (refusal.message.ends_with("\n"))
            EXPECT_EQ(outcome.message, refusal.message);
        else
            EXPECT_TRUE(outcome.message.starts_with(refusal.message)) << outcome.message;
        EXPECT_TRUE(folder.content().empty()) << refusal.message;
    }
}

}  // namespace
}  // namespace railpem::tests
