// The irregularity that a recording brings with it: read, refused with its line, and said by the inspection.

#include "recordings/measured_irregularity.hpp"
#include "recordings/inspection/inspect.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "recordings/files/read_error.hpp"
#include "recordings/inspection/inspection_words.hpp"
#include "recordings/inspection/inspection_writers.hpp"
#include "recordings/loading/load_recording.hpp"
#include "scratch_folder.hpp"

namespace railpem::recordings {
namespace {

using testing::ScratchFolder;

/// 1000 m in steps of 0.25 m: a wave of 5 m and 1 mm amplitude.
std::string profile_text() {
    std::ostringstream text;
    text.precision(12);
    text << "position_m,height_m\n";
    for (int i = 0; i < 4000; ++i)
        text << 0.25 * i << ',' << 1e-3 * std::sin(2.0 * std::numbers::pi * 0.25 * i / 5.0) << '\n';
    return text.str();
}

/// A recording of two sections, 12 s in all, that brings the irregularity named.
RecordingDescription description_with(const ScratchFolder& scratch, const std::string& irregularity) {
    std::ostringstream text;
    text << "axlebox_1\n";
    for (int i = 0; i < 1200; ++i) text << std::sin(0.7 * i) + 0.1 * std::sin(2.3 * i) << '\n';
    scratch.write("recording.csv", text.str());
    return {.data = "recording.csv",
            .sampling_rate_hz = 100.0,
            .speed_m_per_s = 20.0,
            .irregularity = irregularity,
            .channels = {{.name = "axlebox_1", .location = Location::wheel, .index = 1}}};
}

std::string refusal(const std::string& file) {
    try {
        read_irregularity(file);
    } catch (const ReadError& error) {
        return std::to_string(error.line()) + ": " + error.problem() + " | " + error.allowed();
    }
    return "accepted";
}

TEST(MeasuredIrregularity, SpectrumStandsAsInTheFile) {
    const ScratchFolder scratch;
    const MeasuredIrregularity brought = read_irregularity(
        scratch.write("track.csv", "# by the measuring car\npsd_m3;cycles_per_m\n4e-5;0,02\n4e-8;0,2\n"));
    EXPECT_FALSE(brought.is_profile());
    EXPECT_EQ(brought.cycles_per_m, (std::vector<double>{0.02, 0.2}));
    EXPECT_EQ(brought.psd_m3, (std::vector<double>{4e-5, 4e-8}));
    EXPECT_DOUBLE_EQ(brought.longest_wavelength_m(), 50.0);
    EXPECT_DOUBLE_EQ(brought.shortest_wavelength_m(), 5.0);
}

TEST(MeasuredIrregularity, ProfileKeepsItsSamplesAndThePowerOfItsWave) {
    const ScratchFolder scratch;
    const MeasuredIrregularity brought = read_irregularity(scratch.write("track.csv", profile_text()));
    ASSERT_TRUE(brought.is_profile());
    EXPECT_EQ(brought.position_m.size(), 4000U);
    EXPECT_EQ(brought.height_m.size(), 4000U);
    EXPECT_DOUBLE_EQ(brought.height_m[5], 1e-3);  // a quarter of the wave: up stays up
    double power = 0.0;
    for (const double psd : brought.psd_m3) power += psd / brought.segment_length_m;
    // Amplitude²/2. Segments of 120 m hold whole waves, the straight line takes less than 1e-3 of them.
    EXPECT_NEAR(power / 0.5e-6, 1.0, 1e-3);
    EXPECT_GT(brought.averages, 10.0);
}

TEST(MeasuredIrregularity, ErrorsHaveTheirLine) {
    const ScratchFolder scratch;
    const auto refused = [&](const std::string& text) { return refusal(scratch.write("track.csv", text)); };
    const std::string spectrum = "cycles_per_m,psd_m3\n", profile = "position_m,height_m\n";
    EXPECT_EQ(refused(spectrum + "\n0.1,1e-6\n0.1,1e-7\n"),
              "4: cycles_per_m does not increase | strictly increasing values");
    EXPECT_EQ(refused(spectrum + "0.1,1e-6\n0.2,-1\n"),
              "3: psd_m3 cannot be -1 | a number greater than 0 (the spectrum is interpolated log-log)");
    EXPECT_EQ(refused(spectrum + "0,1e-6\n0.2,1e-7\n"), "2: cycles_per_m cannot be 0 | a number greater than 0");
    EXPECT_EQ(refused(spectrum + "0.1,1e-6\n0.2,\n"), "3: a value is missing | a number in cycles_per_m and psd_m3");
    EXPECT_EQ(refused(spectrum + "0.1,1e-6\n"), "0: 1 row of numbers | at least two rows");
    EXPECT_EQ(refused(spectrum + "0.1,1e-6\n0.2,inf\n"), "3: a value is missing | a number in cycles_per_m and psd_m3");
    EXPECT_EQ(refused(spectrum + "0.1,1e-6\n0.2,four\n").rfind("3: 'four' in column 'psd_m3' is not a", 0), 0U);
    EXPECT_EQ(refused("cycles_per_m,psd\n0.1,1e-6\n0.2,1e-7\n").rfind("1: there is no column 'psd_m3'", 0), 0U)
        << refused("cycles_per_m,psd\n0.1,1e-6\n0.2,1e-7\n");
    EXPECT_EQ(refused("wavelength_m,level_db\n1,2\n2,3\n"),
              "1: the columns are wavelength_m, level_db | cycles_per_m and psd_m3 (a spectrum), or position_m and "
              "height_m (a profile, up positive)");
    EXPECT_EQ(
        refused("position_m,height_m,psd_m3\n1,2,3\n2,3,4\n"),
        "1: columns of a spectrum and of a profile in one file | cycles_per_m and psd_m3, or position_m and height_m");
    EXPECT_EQ(refused(profile + "0,0\n1,1\n2,3\n1.5,2\n"),
              "5: position_m does not increase | strictly increasing values");
    EXPECT_EQ(
        refused(profile + "0,0\n1,1\n2,3\n3,0\n4.5,2\n5.5,1\n"),
        "6: the positions do not increase in even steps: 1.5 m among steps of 1 m | steps within 1 % of their mean");
    EXPECT_EQ(refused(profile + "0,0\n1,1\n2,3\n3,0\n4,2\n"),
              "6: a profile of 5 rows is too short | at least 129 rows: eight segments of 16 steps");
    std::string level = profile;
    for (int i = 0; i < 200; ++i) level += std::to_string(i) + ",1\n";
    EXPECT_EQ(refused(level), "0: the profile does not vary | measured heights");
    EXPECT_EQ(refusal(scratch.file("nowhere.csv")).rfind("0: cannot be opened", 0), 0U);
}

TEST(MeasuredIrregularity, ShortestProfileIsRead) {
    const ScratchFolder scratch;
    std::string text = "position_m,height_m\n";
    for (int i = 0; i < 129; ++i) text += std::to_string(i) + "," + std::to_string(std::sin(1.0 * i)) + "\n";
    const MeasuredIrregularity brought = read_irregularity(scratch.write("track.csv", text));
    EXPECT_DOUBLE_EQ(brought.segment_length_m, 16.0);
    EXPECT_DOUBLE_EQ(brought.longest_wavelength_m(), 8.0);
}

TEST(MeasuredIrregularity, ComesWithEverySectionOfTheRecording) {
    const ScratchFolder scratch;
    scratch.write("track.csv", "cycles_per_m,psd_m3\n0.02,4e-5\n2,4e-8\n");
    const RecordingDescription description = description_with(scratch, "track.csv");
    EXPECT_EQ(load(description, scratch.path()).irregularity.psd_m3, (std::vector<double>{4e-5, 4e-8}));
    int sections = 0;
    load_in_sections(description, scratch.path(), 600, [&](const Recording& section) {
        ++sections;
        EXPECT_EQ(section.irregularity.cycles_per_m, (std::vector<double>{0.02, 2.0}));
    });
    EXPECT_EQ(sections, 2);
    EXPECT_FALSE(load(description_with(scratch, ""), scratch.path()).irregularity.brought());
}

TEST(MeasuredIrregularity, InspectionSaysWhatItCovers) {
    const ScratchFolder scratch;
    scratch.write("track.csv", "cycles_per_m,psd_m3\n0.02,4e-5\n2,4e-8\n");
    const InspectionReport spectrum = inspect_file(description_with(scratch, "track.csv"), scratch.path());
    EXPECT_EQ(irregularity_words(spectrum),
              "Irregularity: a measured spectrum of 2 values. It covers wavelengths from 0.5 m to 50 m, at 20 m/s "
              "frequencies from 0.4 Hz to 40 Hz; outside them nothing was measured.");
    EXPECT_NE(to_text(spectrum).find("Irregularity: a measured spectrum"), std::string::npos);
    EXPECT_NE(to_html(spectrum).find("Measured irregularity"), std::string::npos);
    const nlohmann::json json = nlohmann::json::parse(to_json(spectrum).dump());
    EXPECT_EQ(json["irregularity"]["kind"], "spectrum");
    EXPECT_DOUBLE_EQ(json["irregularity"]["high_hz"].get<double>(), 40.0);

    scratch.write("profile.csv", profile_text());
    const InspectionReport profile = inspect_file(description_with(scratch, "profile.csv"), scratch.path());
    EXPECT_TRUE(profile.irregularity.height_m.empty());
    EXPECT_DOUBLE_EQ(profile.profile_step_m, 0.25);
    EXPECT_NEAR(profile.profile_rms_m, 1e-3 / std::numbers::sqrt2, 1e-9);  // whole waves
    EXPECT_NE(irregularity_words(profile).find("profile of 999.8 m in steps of 0.25 m, 0.707 mm rms"),
              std::string::npos)
        << irregularity_words(profile);

    RecordingDescription slow = description_with(scratch, "track.csv");
    slow.speed_m_per_s = 0.0;
    EXPECT_NE(irregularity_words(inspect_file(slow, scratch.path())).find("no speed is known"), std::string::npos);
}

}  // namespace
}  // namespace railpem::recordings
