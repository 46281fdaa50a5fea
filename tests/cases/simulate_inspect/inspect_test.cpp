// `railpem inspect` and `railpem validate` of recordings through the program: a simulated one, spoilt ones, measured
// ones.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

#include "program.hpp"

namespace railpem::tests {
namespace {

using nlohmann::json;

/// One clean record of 21 s (the inspection calls less than 20 s short) for all tests; none of them writes into it.
const Folder& simulated() {
    static std::unique_ptr<Folder> folder;
    if (!folder) {
        folder = std::make_unique<Folder>();
        const Outcome outcome =
            folder->run({"simulate", kCase, "--seconds", "21", "--seed", "11", "--noise", "0.02", "--out", "clean"});
        EXPECT_EQ(outcome.status, 0) << outcome.message;
    }
    return *folder;
}

/// The simulated record in another folder, its samples passed through `change(column, value)`.
template <class Change>
void spoil(const Folder& folder, const Change& change) {
    std::istringstream in(simulated().read("clean/recording.csv"));
    std::string line, text;
    std::getline(in, line);
    text = line + "\n";
    while (std::getline(in, line) && !line.starts_with('#')) {
        std::istringstream cells(line);
        std::string cell;
        for (int column = 0; std::getline(cells, cell, ','); ++column)
            text += (column > 0 ? "," : "") + (column > 0 ? std::to_string(change(column, std::stod(cell))) : cell);
        text += '\n';
    }
    folder.write("recording.csv", text);
    folder.write("recording.toml", simulated().read("clean/recording.toml"));
}

TEST(Inspect, CleanRecordHasItsChannelsAndNoFault) {
    const Outcome outcome = simulated().run({"inspect", "clean", "--json", "--case", kCase});
    ASSERT_EQ(outcome.status, 0) << outcome.message;
    const json report = json::parse(outcome.output);
    ASSERT_EQ(report.at("channels").size(), 9u);
    const std::vector<std::string> names{"axlebox_1", "axlebox_2",  "axlebox_3", "axlebox_4",  "bogie_1",
                                         "bogie_2",   "body_front", "body_rear", "body_centre"};
    for (std::size_t i = 0; i < names.size(); ++i) EXPECT_EQ(report.at("channels")[i].at("name"), names[i]);
    EXPECT_TRUE(report.at("faults").empty()) << report.at("faults").dump(1);
}

TEST(Inspect, OneScreenOfText) {
    const Outcome outcome = simulated().run({"inspect", "clean"});
    ASSERT_EQ(outcome.status, 0) << outcome.message;
    EXPECT_NE(outcome.output.find("9 channels at 1000 Hz, 21 s (21000 samples each)\n\nNo fault was found.\n"),
              std::string::npos)
        << outcome.output;
    EXPECT_LT(std::count(outcome.output.begin(), outcome.output.end(), '\n'), 40);
    EXPECT_EQ(outcome.output,
              simulated().run({"inspect", "clean/recording.toml"}).output);  // the folder or its description
}

// Its axles bend: two axle boxes seemed to be exchanged, by a delay that the resonance made.
TEST(Inspect, TheShippedRecordingIsSound) {
    const std::string shipped = std::string(RAILPEM_SOURCE_DIR) + "/cases/";
    const Outcome outcome =
        simulated().run({"inspect", shipped + "concealed", "--case", shipped + "wei2016/case1.toml"});
    ASSERT_EQ(outcome.status, 0) << outcome.message;
    EXPECT_NE(outcome.output.find("\n\nNo fault was found.\n"), std::string::npos) << outcome.output;
}

/// All axle boxes in g where the description says m/s²: they agree with each other, so only the believed case can tell.
TEST(Inspect, CaseFindsAWrongUnit) {
    const Folder folder;
    spoil(folder, [](int column, double value) { return column <= 4 ? value / 9.80665 : value; });
    const json without = json::parse(folder.run({"inspect", ".", "--json"}).output);
    const Outcome outcome = folder.run({"inspect", ".", "--json", "--case", kCase});
    ASSERT_EQ(outcome.status, 3) << outcome.message;
    const auto count = [](const json& report) {
        std::size_t found = 0;
        for (const json& fault : report.at("faults"))
            found += fault.at("kind") == "wrong-unit" ? fault.at("channels").size() : 0;
        return found;
    };
    EXPECT_EQ(count(json::parse(outcome.output)), 4U) << outcome.output.substr(0, 2000);
    EXPECT_EQ(count(without), 0U);
}

/// The report is complete, and a script learns from the status that the data are not to be trusted.
TEST(Inspect, ErrorsInTheDataEndWithStatusThree) {
    const Folder folder;
    spoil(folder, [](int column, double value) {
        return column == 5 ? std::clamp(value, -1.0, 1.0) : column == 8 ? 0.5 : value;
    });
    const Outcome outcome = folder.run({"inspect", "."});
    EXPECT_EQ(outcome.status, 3) << outcome.message;
    EXPECT_NE(outcome.output.find("clipping bogie_1"), std::string::npos) << outcome.output;
    EXPECT_NE(outcome.output.find("constant body_rear"), std::string::npos) << outcome.output;
    EXPECT_NE(outcome.output.find("Not to be trusted as it is"), std::string::npos);
}

/// A hammer test whose values are conjugated, and an accelerance called a receptance: told with and without a case.
TEST(Inspect, ReceptancesThatMakeNoSenseAreNamed) {
    const Folder folder;
    std::string conjugated = "frequency_hz,re_m_per_n,im_m_per_n\n", accelerance = "frequency_hz,magnitude_m_per_n\n";
    for (const double f : {50.0, 63.0, 80.0, 100.0, 125.0, 160.0}) {
        conjugated += std::to_string(f) + ",1.3e-8,6e-10\n";
        accelerance += std::to_string(f) + "," + std::to_string(1.3e-8 * std::pow(6.2832 * f, 2)) + "\n";
    }
    folder.write("c.csv", conjugated);
    folder.write("a.csv", accelerance);
    folder.write("c.toml", "kind = \"receptance\"\ndata = \"c.csv\"\n");
    folder.write("a.toml", "kind = \"receptance\"\ndata = \"a.csv\"\n");
    for (const std::vector<std::string>& with : {std::vector<std::string>{}, {"--case", kCase}}) {
        std::vector<std::string> arguments{"inspect", "c.toml"};
        arguments.insert(arguments.end(), with.begin(), with.end());
        const Outcome first = folder.run(arguments);
        EXPECT_EQ(first.status, 3);
        EXPECT_NE(first.output.find("conjugated"), std::string::npos) << first.output;
        arguments[1] = "a.toml";
        const Outcome second = folder.run(arguments);
        EXPECT_EQ(second.status, 3);
        EXPECT_NE(second.output.find("accelerance"), std::string::npos) << second.output;
    }
    const Outcome valid = folder.run({"validate", "c.toml"});
    EXPECT_EQ(valid.status, 0);
    EXPECT_NE(valid.message.find("c.toml: warning: "), std::string::npos) << valid.message;
}

TEST(Inspect, PagesAndSeveralRecordings) {
    const Folder folder;
    spoil(folder, [](int, double value) { return value; });
    const std::string toml = folder.read("recording.toml");
    folder.write("other.toml", toml);
    const Outcome outcome = folder.run({"inspect", "recording.toml", "other.toml", "--json", "--out", "pages"});
    ASSERT_EQ(outcome.status, 0) << outcome.message;
    EXPECT_EQ(json::parse(outcome.output).size(), 2u);
    EXPECT_TRUE(folder.has("pages/other.inspection.json"));
    EXPECT_NE(folder.read("pages/other.inspection.html").find("axlebox_3"), std::string::npos);
    ASSERT_EQ(folder.run({"inspect", "other.toml", "--html", "page.html"}).status, 0);
    // without the comment that says which command made it
    const auto page = [&](const char* file) {
        const std::string text = folder.read(file);
        return text.substr(text.find("<html"));
    };
    EXPECT_EQ(page("page.html"), page("pages/other.inspection.html"));
}

struct WrongDescription {
    std::string from, to;  ///< in the description
    std::string message;
};

/// A description that is wrong is refused with file, line and remedy, by inspect and by validate alike.
TEST(Inspect, BadDescriptionsAreRefused) {
    const std::string good =
        "sampling_rate_hz = 1000.0\ndata = \"d.csv\"\n[[channel]]\nname = \"a\"\nlocation = \"wheel\"\nindex = 1\n";
    const std::vector<WrongDescription> refusals{
        {"sampling_rate_hz", "sampling_rate",
         "r.toml:1:1: unknown key 'sampling_rate' in the file\n  1 | sampling_rate = 1000.0\n    | "
         "^^^^^^^^^^^^^\nallowed: title, kind, data, sampling_rate_hz, speed_m_per_s, "
         "speed_standard_error_m_per_s, payload_kg, irregularity, time_column, averages, place, channel\ndid you mean "
         "'sampling_rate_hz', in Hz?\n"},
        {"index = 1", "index = 5",
         "r.toml:6:9: 'index' cannot be 5\n  6 | index = 5\n    |         ^\nallowed: an integer between 1 and 4\n"},
        {"\"wheel\"", "\"wheels\"",
         "r.toml:5:12: 'location' cannot be \"wheels\"\n  5 | location = \"wheels\"\n    |            "
         "^^^^^^^^\nallowed: \"none\", \"body\", \"bogie\", \"wheel\", \"rail\"\ndid you mean \"wheel\"?\n"},
        {"wheel\"\nindex = 1", "bogie\"\nindex = 3",
         "r.toml:6:9: channel[1].index: 3 does not say which one\n  6 | index = 3\n    |         ^\nallowed: 1 to 2\n"},
        {"index = 1", "index = 1\nunit = \"furlong\"", "r.toml:7:8: channel[1].unit: "},
        {"d.csv", "nowhere.csv",
         "nowhere.csv: there is no such file\nallowed: a data file beside the description\nnamed by: r.toml\n"},
        {"d.csv", "d.docx", "d.docx: there is no such file\n"},
        {"name = \"a\"", "name = \"A1\"", "d.csv:1: "},
        {"d.csv", "ragged.csv", "ragged.csv:3: "},
        {"data =", "irregularity = \"no.csv\"\ndata =",
         "r.toml:2:16: there is no file 'no.csv'\n  2 | irregularity = \"no.csv\"\n    |                "
         "^^^^^^^^\nallowed: a path relative to this file\n"},
    };
    for (const WrongDescription& refusal : refusals) {
        const Folder folder;
        std::string text = good;
        text.replace(text.find(refusal.from), refusal.from.size(), refusal.to);
        folder.write("r.toml", text);
        folder.write("d.csv", "time_s,a\n0,1\n0.001,2\n0.002,1\n");
        folder.write("ragged.csv", "time_s,a\n0,1\n0.001,2,3\n0.002,1\n");
        for (const std::vector<std::string>& arguments :
             {std::vector<std::string>{"inspect", "r.toml", "--out", "out"}, {"validate", "r.toml"}}) {
            const Outcome outcome = folder.run(arguments);
            EXPECT_EQ(outcome.status, 2) << refusal.message;
            if (std::count(refusal.message.begin(), refusal.message.end(), '\n') > 1)
                EXPECT_EQ(outcome.message, refusal.message);
            else
                EXPECT_TRUE(outcome.message.starts_with(refusal.message)) << outcome.message;
            EXPECT_FALSE(folder.has("out"));
        }
    }
}

TEST(Inspect, DataWithoutDescriptionAndEmptyFolders) {
    const Folder folder;
    folder.write("d.csv", "time_s,a\n0,1\n");
    EXPECT_EQ(folder.run({"inspect", "d.csv"}).message,
              "d.csv: is data without its description\nallowed: a TOML file that names it in `data`; railpem describe "
              "recording says how\n");
    EXPECT_EQ(folder.run({"inspect", "."}).message,
              ".: the folder holds no recording.toml\nallowed: the folder of a recording, or its description\n");
}

TEST(Validate, TellsItsInputsApart) {
    EXPECT_EQ(simulated().run({"validate", "clean/recording.toml"}).output,
              "clean/recording.toml: a valid recording\n");
    EXPECT_EQ(simulated().run({"validate", kCase}).output.find(kCase + ": a valid case"), 0u);
    const std::string sweep = std::string(RAILPEM_SOURCE_DIR) + "/cases/wei2016/pads.sweep.toml";
    EXPECT_EQ(simulated().run({"validate", sweep}).output.find(sweep + ": a valid sweep"), 0u);
}

/// Folder of the public measured data, with a slash; empty when there is none.
std::string measured_data() {
    const char* folder = std::getenv("RAILPEM_RECORDINGS");
    return folder && std::filesystem::is_directory(folder) ? std::filesystem::absolute(folder).string() + "/" : "";
}

/// Two kilometres of axle-box acceleration: the offset and the unknown scale must be said.
TEST(MeasuredData, TwoKilometresOfAxleBoxes) {
    const std::string base = measured_data();
    if (base.empty()) GTEST_SKIP() << "RAILPEM_RECORDINGS is not set";
    const Folder folder;
    folder.write(
        "km1.toml",
        "sampling_rate_hz = 2000\ndata = \"" + base +
            "axlebox-two-kilometres/km1.csv\"\n"
            "[[channel]]\nname = \"left\"\nscale = \"unknown\"\nlocation = \"wheel\"\nindex = 1\nside = \"left\"\n"
            "[[channel]]\nname = \"right\"\nscale = \"unknown\"\nlocation = \"wheel\"\nindex = 1\nside = \"right\"\n"
            "[[channel]]\nname = \"speed\"\ncolumn = \"speed_kmh\"\nquantity = \"speed\"\nunit = \"km/h\"\n"
            "[[channel]]\nname = \"mileage\"\ncolumn = \"km\"\nquantity = \"mileage\"\nunit = \"km\"\n");
    const Outcome outcome = folder.run({"inspect", "km1.toml", "--html", "km1.html"});
    ASSERT_EQ(outcome.status, 0) << outcome.message;
    EXPECT_NE(outcome.output.find("2 channels at 2000 Hz, 33 s (66000 samples each)"), std::string::npos)
        << outcome.output;
    EXPECT_NE(outcome.output.find("offset left"), std::string::npos) << outcome.output;
    EXPECT_NE(outcome.output.find("unknown-scale"), std::string::npos) << outcome.output;
    EXPECT_GT(folder.read("km1.html").size(), 100000u);  // charts and spectrograms are in it
}

/// Decay rates of one rail and date: read as what they are, without a claim about sensors.
TEST(MeasuredData, DecayRates) {
    const std::string base = measured_data();
    if (base.empty()) GTEST_SKIP() << "RAILPEM_RECORDINGS is not set";
    std::istringstream in(text_of(base + "sbb-niederwangen/track_decay_rate.csv"));
    std::string line, text = "centre_hz,decay_rate_db_per_m\n";
    int bands = 0;
    while (std::getline(in, line)) {
        if (!line.starts_with("Ni,B3,h,hoch,FALSE,,8,") || line.find(",li,h,") == std::string::npos) continue;
        text += line.substr(line.find(",li,h,") + 6) + "\n";
        ++bands;
    }
    ASSERT_GT(bands, 10);
    const Folder folder;
    folder.write("tdr.csv", text);
    folder.write("tdr.toml", "kind = \"decay-rate\"\ndata = \"tdr.csv\"\n");
    const Outcome outcome = folder.run({"inspect", "tdr.toml"});
    ASSERT_EQ(outcome.status, 0) << outcome.message;
    std::ostringstream expected;
    expected << "decay rate       " << bands << " bands, 100 to 5000 Hz";
    EXPECT_NE(outcome.output.find(expected.str()), std::string::npos) << outcome.output;
}

}  // namespace
}  // namespace railpem::tests
