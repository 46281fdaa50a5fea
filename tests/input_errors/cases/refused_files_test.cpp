// Files that cannot be read, folders that cannot be written, disks that are full, arguments that mean nothing.

#include <gtest/gtest.h>

#include "program_run.hpp"

namespace railpem::tests {
namespace {

using Names = std::vector<std::string>;

TEST(RefusedFiles, NoSuchFile) {
    const ProgramFolder folder;
    const Outcome outcome = folder.run({"solve", "case.toml", "--out", "results"});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.message,
              "case.toml: cannot be read: No such file or directory\nallowed: a TOML file that can be read\n");
    EXPECT_EQ(folder.content(), Names{});
}

TEST(RefusedFiles, FolderInPlaceOfAFile) {
    const ProgramFolder folder;
    const Outcome solved = folder.run({"solve", ".", "--out", "results"});
    EXPECT_EQ(solved.status, 2);
    EXPECT_EQ(solved.message, ".: is a folder\nallowed: a TOML file\n");
    const Outcome validated = folder.run({"validate", "."});  // a folder may be a recording
    EXPECT_EQ(validated.status, 2);
    EXPECT_EQ(validated.message,
              ".: the folder holds no recording.toml\nallowed: the folder of a recording, or its description\n");
}

TEST(RefusedFiles, EnormousFile) {
    const ProgramFolder folder;
    folder.write("case.toml", "");
    std::filesystem::resize_file(folder.path("case.toml"), (16u << 20) + 1);
    const Outcome outcome = folder.run({"validate", "case.toml"});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.message, "case.toml: is too large to be an input file\nallowed: at most 16 MiB\n");
}

TEST(RefusedFiles, DeviceThatNeverEnds) {
    const ProgramFolder folder;
    const Outcome outcome = folder.run({"validate", "/dev/zero"});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.message, "/dev/zero: is too large to be an input file\nallowed: at most 16 MiB\n");
}

TEST(RefusedFiles, OneBadCaseAmongGoodOnesStopsAll) {
    const ProgramFolder folder;
    folder.write("good.toml", minimal_case());
    folder.write("bad.toml", minimal_case("modes = 200", "modes = 0"));
    const Outcome outcome = folder.run({"solve", "good.toml", "bad.toml", "--out", "results"});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.message,
              "bad.toml:45:9: 'modes' cannot be 0\n  45 | modes = 0\n     |         ^\nallowed: an integer between 1 "
              "and 5000\n");
    EXPECT_EQ(folder.content(), (Names{"bad.toml", "good.toml"}));
}

TEST(RefusedFiles, TwoCasesOfOneName) {
    const ProgramFolder folder;
    folder.write("case.toml", minimal_case());
    const Outcome outcome = folder.run({"solve", "case.toml", "./case.toml", "--out", "results"});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.message,
              "./case.toml: its results would be called case.psd.csv, like those of case.toml\nallowed: case files of "
              "different names\n");
    EXPECT_EQ(folder.content(), Names{"case.toml"});
}

TEST(RefusedFiles, OutputFolderIsAFile) {
    const ProgramFolder folder;
    folder.write("case.toml", minimal_case());
    folder.write("results", "mine");
    for (const char* out : {"results", "results/inner"}) {
        const Outcome outcome = folder.run({"solve", "case.toml", "--out", out});
        EXPECT_EQ(outcome.status, 2);
        EXPECT_EQ(outcome.message,
                  "--out " + std::string(out) +
                      ": cannot be written: Not a directory\nallowed: a folder that can be written, or a new one\n");
    }
    EXPECT_EQ(folder.read("results"), "mine");
}

TEST(RefusedFiles, OutputFolderThatCannotBeMade) {
    const ProgramFolder folder;
    folder.write("case.toml", minimal_case());
    const Outcome outcome = folder.run({"static", "case.toml", "--out", "/proc/results"});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.message,
              "--out /proc/results: cannot be written: No such file or directory\nallowed: a folder that can be "
              "written, or a new one\n");
}

TEST(RefusedFiles, DiskFullWhileATableIsWritten) {
    const ProgramFolder folder;
    folder.write("case.toml", minimal_case());
    // 200 lines of 18 columns take 40 kB; the limit on the size of a file stops the write as a full disk does.
    const Outcome outcome = folder.run({"solve", "case.toml", "--out", "new/results"}, 10000);
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.message,
              "railpem: cannot write new/results/case.psd.csv: File too large\nnothing of this run was kept\n");
    EXPECT_EQ(folder.content(), Names{"case.toml"});
}

TEST(RefusedFiles, DiskFullLeavesEarlierResultsAlone) {
    const ProgramFolder folder;
    folder.write("case.toml", minimal_case());
    EXPECT_EQ(folder.run({"solve", "case.toml", "--out", "results"}).status, 0);
    const std::string before = folder.read("results/case.psd.csv");
    EXPECT_EQ(folder.run({"solve", "case.toml", "--out", "results", "--set", "vehicle.payload_kg=9000"}, 10000).status,
              1);
    EXPECT_EQ(folder.read("results/case.psd.csv"), before);
    EXPECT_EQ(folder.content(), (Names{"case.toml", "results", "results/case.psd.csv", "results/case.summary.json"}));
}

TEST(RefusedFiles, FolderInTheWayOfATable) {
    const ProgramFolder folder;
    folder.write("case.toml", minimal_case());
    std::filesystem::create_directories(folder.path("results/case.summary.json"));
    const Outcome outcome = folder.run({"solve", "case.toml", "--out", "results"});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.message,
              "railpem: cannot write results/case.summary.json: a folder of that name is in the way\nnothing of this "
              "run was kept\n");
    EXPECT_EQ(folder.content(), (Names{"case.toml", "results", "results/case.summary.json"}));
}

TEST(RefusedFiles, FullStandardOutput) {
    const ProgramFolder folder;
    const Outcome outcome = folder.run({"describe", "case"}, 0, "/dev/full");
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.message, "railpem: cannot write to the standard output\n");
}

TEST(RefusedArguments, UnknownVerb) {
    const ProgramFolder folder;
    const Outcome outcome = folder.run({"slove"});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_TRUE(outcome.message.starts_with("railpem: unknown verb 'slove'\nallowed: solve, static, "))
        << outcome.message;
    EXPECT_TRUE(outcome.message.ends_with("\ndid you mean 'solve'?\n")) << outcome.message;
}

TEST(RefusedArguments, UnknownOption) {
    const ProgramFolder folder;
    const Outcome outcome = folder.run({"solve", "case.toml", "--out", "results", "--bnds"});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.message,
              "railpem solve: unknown argument '--bnds'\n"
              "allowed: --help, --out, --bands, --threads, --strict, --set, --force; railpem solve --help says more\n"
              "did you mean '--bands'?\n");
}

TEST(RefusedArguments, MissingOutputFolder) {
    const ProgramFolder folder;
    const Outcome outcome = folder.run({"solve", "case.toml"});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.message,
              "railpem solve: --out is required\n"
              "allowed: --help, --out, --bands, --threads, --strict, --set, --force; railpem solve --help says more\n");
}

TEST(RefusedArguments, ThreadsOutOfRange) {
    const ProgramFolder folder;
    const Outcome outcome = folder.run({"solve", "case.toml", "--out", "results", "--threads", "0"});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.message,
              "railpem solve: --threads: Value 0 not in range 1 to 1024\n"
              "allowed: what railpem solve --help says of it\n");
}

TEST(RefusedArguments, NoFolderIsNamed) {
    const ProgramFolder folder;
    folder.write("case.toml", minimal_case());
    const Outcome outcome = folder.run({"static", "case.toml", "--out", ""});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_TRUE(outcome.message.starts_with("--out: no folder is named\nallowed: ")) << outcome.message;
}

TEST(RefusedArguments, CapitalLettersOfAVerb) {
    const ProgramFolder folder;
    const Outcome outcome = folder.run({"SOLVE", "case.toml"});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_TRUE(outcome.message.ends_with("\ndid you mean 'solve'?\n")) << outcome.message;
}

// A file is put in place by renaming it, which would make a file of the device.
TEST(RefusedArguments, ADeviceIsNotWrittenOver) {
    const ProgramFolder folder;
    const Outcome truth =
        folder.run({"simulate", "case.toml", "--seconds", "1", "--seed", "1", "--out", "run", "--truth", "/dev/null"});
    EXPECT_EQ(truth.status, 2);
    EXPECT_EQ(truth.message, "--truth /dev/null: is a device or a pipe\nallowed: a file\n");
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST(RefusedFiles, AColumnThatIsNotThereNamesItsDescription) {
    const ProgramFolder folder;
    folder.write("recording.toml",
                 "sampling_rate_hz = 100.0\ndata = \"recording.csv\"\n[[channel]]\nname = \"axlebox\"\n");
    folder.write("recording.csv", "axelbox\n1\n2\n");
    const Outcome outcome = folder.run({"validate", "recording.toml"});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.message,
              "recording.csv:1: there is no column 'axlebox' (did you mean 'axelbox'?)\nallowed: axelbox\nnamed by: "
              "recording.toml\n");
}

TEST(RefusedArguments, UnknownPage) {
    const ProgramFolder folder;
    const Outcome outcome = folder.run({"describe", "csae"});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_TRUE(outcome.message.starts_with("railpem describe: no page about 'csae'\nallowed: case"))
        << outcome.message;
    EXPECT_TRUE(outcome.message.ends_with("\ndid you mean 'case'?\n")) << outcome.message;
}

TEST(Arguments, HelpAndVersionAreNotErrors) {
    const ProgramFolder folder;
    EXPECT_EQ(folder.run({"--help"}).status, 0);
    EXPECT_EQ(folder.run({"solve", "--help"}).status, 0);
    EXPECT_TRUE(folder.run({"--version"}).output.starts_with("railpem "));
}

TEST(RefusedFiles, MeasuredIrregularityOfARecording) {
    const ProgramFolder folder;
    folder.write(
        "recording.toml",
        "sampling_rate_hz = 100.0\ndata = \"recording.csv\"\nirregularity = \"track.csv\"\n[[channel]]\nname = "
        "\"a\"\n");
    std::string samples = "a\n";
    for (int i = 0; i < 400; ++i) samples += std::to_string(i * 37 % 11) + "\n";
    folder.write("recording.csv", samples);
    for (const char* verb : {"validate", "inspect"}) {
        const Outcome missing = folder.run({verb, "recording.toml"});
        EXPECT_EQ(missing.status, 2);
        EXPECT_EQ(
            missing.message,
            "recording.toml:3:16: there is no file 'track.csv'\n  3 | irregularity = \"track.csv\"\n    |            "
            "    ^^^^^^^^^^^\nallowed: a path relative to this file\n");
        folder.write("track.csv", "cycles_per_m,psd_m3\n0.02,4e-5\n0.01,4e-8\n");
        const Outcome falling = folder.run({verb, "recording.toml"});
        EXPECT_EQ(falling.status, 2);
        EXPECT_EQ(falling.message,
                  "track.csv:3: cycles_per_m does not increase\nallowed: strictly increasing values\nnamed by: "
                  "recording.toml\n");
        folder.write("track.csv", "cycles_per_m,psd_m3\n0.02,4e-5\n2,4e-8\n");
        EXPECT_EQ(folder.run({verb, "recording.toml"}).status, 0);
        std::filesystem::remove(folder.path("track.csv"));
    }
}

}  // namespace
}  // namespace railpem::tests
