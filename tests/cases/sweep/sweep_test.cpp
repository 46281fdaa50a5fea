// Sweeps through the program: the table against single solutions, the same bits for any number of threads and after any
// number of kills, and refusals before anything runs.

#include <fcntl.h>
#include <gtest/gtest.h>
#include <hdf5.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <thread>

namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

struct Folder {
    fs::path path;
    Folder() {
        std::string name = (fs::temp_directory_path() / "railpem_sweep_XXXXXX").string();
        path = mkdtemp(name.data());
    }
    ~Folder() { fs::remove_all(path); }
};

/// Starts the program; its messages go to the file `errors`.
pid_t start(const std::vector<std::string>& arguments, const fs::path& errors) {
    const pid_t child = fork();
    if (child != 0) return child;
    const int out = open(errors.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    dup2(out, 2);
    std::vector<char*> argv{const_cast<char*>(RAILPEM_PROGRAM)};
    for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    execv(RAILPEM_PROGRAM, argv.data());
    _exit(127);
}

int run(const std::vector<std::string>& arguments, const fs::path& errors) {
    int status = 0;
    waitpid(start(arguments, errors), &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

const std::string kCase = std::string(RAILPEM_SOURCE_DIR) + "/cases/wei2016/case2.toml";

std::string sweep_text(const std::string& design, const std::string& vary) {
    return "case = \"" + kCase + "\"\n" + design + vary +
           "[[keep]]\nresponse = \"wheel_1\"\nquantity = \"peak-level\"\n[[keep]]\nresponse = \"rail_1\"\nquantity = "
           "\"bands\"\n";
}

const std::string kTwoAxes =
    "[[vary]]\nkey = \"track.pads.exponent\"\nfrom = 0.0\nto = 0.3\ncount = 30\n"
    "[[vary]]\nkey = \"track.pads.damping_n_s_per_m\"\nvalues = [5e4, 6e4, 7e4, 8e4, 9e4, 1e5]\n";

struct Sweep {
    Folder folder;
    fs::path file, errors;
    explicit Sweep(const std::string& text) : file(folder.path / "s.toml"), errors(folder.path / "errors") {
        std::ofstream(file) << text;
    }
    std::vector<std::string> command(const std::string& out, std::vector<std::string> more = {}) const {
        std::vector<std::string> arguments{"sweep", file.string(),           "--out", (folder.path / out).string(),
                                           "--set", "frequency.step_hz=0.25"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return arguments;
    }
};

/// A table without the comment that says where it comes from.
std::string rows_of(const std::string& table) {
    return table.substr(0, table.find("\n#"));
}

TEST(Sweep, SameTableForAnyNumberOfThreads) {
    const Sweep sweep(sweep_text("", kTwoAxes));
    ASSERT_EQ(run(sweep.command("one", {"--threads", "1"}), sweep.errors), 0);
    ASSERT_EQ(run(sweep.command("two", {"--threads", "2"}), sweep.errors), 0);
    const std::string one = text_of(sweep.folder.path / "one/s.csv");
    EXPECT_EQ(rows_of(one), rows_of(text_of(sweep.folder.path / "two/s.csv")));
    EXPECT_EQ(one.substr(0, one.find('\n')),
              "case,track.pads.exponent,track.pads.damping_n_s_per_m,quantity,response,frequency_hz,value");
    EXPECT_FALSE(fs::exists(sweep.folder.path / "one/s.unfinished"));
}

/// One case of the table against `railpem solve` of the same case.
TEST(Sweep, AgreesWithSolve) {
    const Sweep sweep(sweep_text("", kTwoAxes));
    ASSERT_EQ(run(sweep.command("out"), sweep.errors), 0);
    ASSERT_EQ(run({"solve", kCase, "--out", (sweep.folder.path / "single").string(), "--set", "frequency.step_hz=0.25",
                   "--set", "track.pads.exponent=0.3", "--set", "track.pads.damping_n_s_per_m=1e5"},
                  sweep.errors),
              0);
    std::istringstream table(text_of(sweep.folder.path / "out/s.csv"));
    double kept = 0.0;
    for (std::string line; std::getline(table, line);)
        if (line.starts_with("180,") && line.find("peak_level") != std::string::npos)
            kept = std::stod(line.substr(line.rfind(',') + 1));
    const std::string summary = text_of(sweep.folder.path / "single/case2.summary.json");
    const std::string name = "\"peak_psd_m2_per_s4_per_hz\": ";
    const double peak = std::stod(summary.substr(summary.find(name, summary.find("\"wheel_1\"")) + name.size()));
    EXPECT_NEAR(kept / peak, 1.0, 2e-9);  // the table carries nine digits
}

/// Killed with SIGKILL at random moments and started again until it is done: the same table, bit for bit.
TEST(Sweep, SurvivesKills) {
    const Sweep sweep(sweep_text("design = \"latin-hypercube\"\nsamples = 1500\n",
                                 "[[vary]]\nkey = \"track.pads.exponent\"\nfrom = 0.0\nto = 0.3\n"));
    ASSERT_EQ(run(sweep.command("whole"), sweep.errors), 0);
    std::mt19937 random(7);
    int kills = 0;
    for (int attempt = 0; attempt < 20; ++attempt) {
        const pid_t child = start(sweep.command("killed"), sweep.errors);
        std::this_thread::sleep_for(std::chrono::milliseconds(20 + random() % 100));
        kill(child, SIGKILL);
        int status = 0;
        waitpid(child, &status, 0);
        kills += WIFSIGNALED(status) ? 1 : 0;
    }
    ASSERT_EQ(run(sweep.command("killed"), sweep.errors), 0);
    EXPECT_GE(kills, 3);  // else the machine was too fast for the test to say anything
    EXPECT_EQ(rows_of(text_of(sweep.folder.path / "whole/s.csv")),
              rows_of(text_of(sweep.folder.path / "killed/s.csv")));
}

/// Every stratum of a Latin hypercube holds exactly one sample.
TEST(Sweep, LatinHypercubeFillsEveryStratum) {
    const Sweep sweep("case = \"" + kCase +
                      "\"\ndesign = \"latin-hypercube\"\nsamples = 100\n[[vary]]\nkey = \"track.pads.exponent\"\nfrom "
                      "= 0.0\nto = 0.5\n"
                      "[[keep]]\nresponse = \"body\"\nquantity = \"rms\"\n");
    ASSERT_EQ(run(sweep.command("out"), sweep.errors), 0);
    std::istringstream table(text_of(sweep.folder.path / "out/s.csv"));
    std::vector<int> hits(100, 0);
    std::string line;
    std::getline(table, line);
    while (std::getline(table, line) && !line.starts_with('#'))
        ++hits[static_cast<std::size_t>(std::stod(line.substr(line.find(',') + 1)) / 0.005)];
    for (const int hit : hits) EXPECT_EQ(hit, 1);
}

TEST(Sweep, Hdf5HoldsTheSameValues) {
    const Sweep sweep(sweep_text("", kTwoAxes));
    ASSERT_EQ(run(sweep.command("csv"), sweep.errors), 0);
    ASSERT_EQ(run(sweep.command("h5", {"--format", "hdf5"}), sweep.errors), 0);
    const hid_t file = H5Fopen((sweep.folder.path / "h5/s.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    ASSERT_GE(file, 0);
    const hid_t set = H5Dopen2(file, "value", H5P_DEFAULT), space = H5Dget_space(set);
    std::vector<double> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
    H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    H5Sclose(space);
    H5Dclose(set);
    H5Fclose(file);
    std::istringstream table(text_of(sweep.folder.path / "csv/s.csv"));
    std::string line;
    std::getline(table, line);
    for (std::size_t row = 0; row < values.size(); ++row) {
        ASSERT_TRUE(std::getline(table, line));
        const double value = std::stod(line.substr(line.rfind(',') + 1));
        EXPECT_NEAR(values[row], value, 1e-8 * std::abs(value));
    }
    while (std::getline(table, line)) EXPECT_EQ(line.front(), '#') << line;  // which command made it
}

struct Refusal {
    const char* name;
    std::string design, vary, message;
};

/// Refused before anything runs; the whole message, with the name of the file in front.
TEST(Sweep, BadSweepsAreRefused) {
    const std::vector<Refusal> refusals{
        {"unknown key", "", "[[vary]]\nkey = \"track.pads.exponnent\"\nvalues = [0.1]\n",
         "3:7: the case has no number 'track.pads.exponnent'\n  3 | key = \"track.pads.exponnent\"\n    |       "
         "^^^^^^^^^^^^^^^^^^^^^^\n"
         "allowed: a dotted key of a number; railpem describe case lists them\ndid you mean 'track.pads.exponent'?\n"},
        {"empty range", "", "[[vary]]\nkey = \"track.pads.exponent\"\n",
         "3:7: no values for 'track.pads.exponent'\n  3 | key = \"track.pads.exponent\"\n    |       "
         "^^^^^^^^^^^^^^^^^^^^^\nallowed: values, or from, to and count\n"},
        {"impossible combination", "",
         "[[vary]]\nkey = \"vehicle.wheelbase_m\"\nvalues = [2.0, 3.0]\n[[vary]]\nkey = "
         "\"vehicle.bogie_distance_m\"\nvalues = [18.0, 2.5]\n",
         "3:7: case 4 (vehicle.wheelbase_m = 3, vehicle.bogie_distance_m = 2.5) cannot be: vehicle.wheelbase_m: the "
         "wheelbase is not shorter than the bogie "
         "distance, so wheels of different bogies would pass each other\n  3 | key = \"vehicle.wheelbase_m\"\n    |    "
         "   ^^^^^^^^^^^^^^^^^^^^^\nallowed: less than vehicle.bogie_distance_m\n"},
    };
    for (const Refusal& refusal : refusals) {
        const Sweep sweep(sweep_text(refusal.design, refusal.vary));
        EXPECT_EQ(run(sweep.command("out"), sweep.errors), 2) << refusal.name;
        EXPECT_EQ(text_of(sweep.errors), sweep.file.string() + ":" + refusal.message) << refusal.name;
        EXPECT_FALSE(fs::exists(sweep.folder.path / "out")) << refusal.name;
    }
}

/// What another sweep left unfinished in the folder is not overwritten.
TEST(Sweep, AnotherSweepsRestIsKept) {
    const Sweep sweep(sweep_text("", kTwoAxes));
    fs::create_directory(sweep.folder.path / "out");
    std::ofstream(sweep.folder.path / "out/s.unfinished") << "something of more than twenty-four bytes, certainly";
    EXPECT_EQ(run(sweep.command("out"), sweep.errors), 2);
    EXPECT_TRUE(text_of(sweep.folder.path / "out/s.unfinished").starts_with("something"));
}

}  // namespace
