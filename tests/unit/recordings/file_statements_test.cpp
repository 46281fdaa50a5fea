// What a data file says of its numbers, used where the description is silent and held against it where it speaks.

#include <gtest/gtest.h>
#include <sndfile.h>

#include <algorithm>
#include <cmath>

#include "parameters/parameter_error.hpp"
#include "recordings/files/known_units.hpp"
#include "recordings/files/read_binary.hpp"
#include "recordings/files/read_error.hpp"
#include "recordings/inspection/inspect.hpp"
#include "recordings/inspection/inspection_words.hpp"
#include "recordings/loading/hold_against_file.hpp"
#include "recordings/loading/load_recording.hpp"
#include "recordings/units.hpp"
#include "scratch_folder.hpp"

namespace railpem::recordings {
namespace {

using testing::ScratchFolder;

constexpr double g = standard_gravity_m_per_s2;

RecordingDescription one_channel(const std::string& data, const std::string& unit = "") {
    RecordingDescription description;
    description.data = data;
    description.channels = {{.name = "a", .unit = unit, .location = Location::wheel, .index = 1}};
    return description;
}

Recording loaded(const std::string& content, const RecordingDescription& description) {
    const ScratchFolder folder;
    folder.write(description.data, content);
    return load(description, folder.path());
}

const std::string four_rows = "0.0,1.5\n0.1,-2.5\n0.2,3.5\n0.3,0.5\n";

TEST(FileStatements, UnitsOfTheFileAreUsedWhereTheDescriptionIsSilent) {
    for (const std::string header : {"time,a [g]\n", "time,a (g)\n", "time,a\ns,g\n", "time,a\n[s],[g]\n",
                                     "time,\"a, g\"\n", "Unit: g\ntime,a\n"}) {
        const Recording recording = loaded(header + four_rows, one_channel("r.csv"));
        EXPECT_DOUBLE_EQ(recording.series.channels[0].samples[0], 1.5 * g) << header;
        EXPECT_TRUE(recording.contradictions.empty()) << header;
        EXPECT_NE(recording.series.channels[0].unit_says.find("g by the data file ("), std::string::npos) << header;
    }
    EXPECT_DOUBLE_EQ(loaded("time,a [mm/s\xC2\xB2]\n" + four_rows, one_channel("r.csv")).series.channels[0].samples[0],
                     1.5e-3);
    EXPECT_EQ(loaded("time,a\n" + four_rows, one_channel("r.csv")).series.channels[0].unit_says,
              "m/s^2, which nobody says");
}

TEST(FileStatements, TheInspectionSaysWhereEachUnitComesFrom) {
    const InspectionReport report = inspect(loaded("time,a\ns,g\n" + four_rows, one_channel("r.csv")), {});
    EXPECT_EQ(unit_words(report), "Numbers in the file: g by the data file (row of units, line 2).");
}

TEST(FileStatements, AContradictionIsOneMessageWithBoth) {
    const Recording recording = loaded("time,a\ns,g\n" + four_rows, one_channel("r.csv", "m/s^2"));
    EXPECT_DOUBLE_EQ(recording.series.channels[0].samples[0], 1.5);  // the description is followed
    ASSERT_EQ(recording.contradictions.size(), 1U);
    EXPECT_EQ(recording.contradictions[0].kind, FaultKind::wrong_unit);
    EXPECT_EQ(recording.contradictions[0].severity, Severity::error);
    EXPECT_NE(recording.contradictions[0].says.find("the data file says 'g' (row of units, line 2), the description "
                                                    "'m/s^2'"),
              std::string::npos)
        << recording.contradictions[0].says;
    const std::vector<Fault> faults = inspect(recording, {}).faults;
    EXPECT_TRUE(
        std::any_of(faults.begin(), faults.end(), [](const Fault& own) { return own.kind == FaultKind::wrong_unit; }));
    EXPECT_TRUE(loaded("time,a\ns,g\n" + four_rows, one_channel("r.csv", "g")).contradictions.empty());
    EXPECT_TRUE(loaded("time,a [m/s2]\n" + four_rows, one_channel("r.csv", "m/s\xC2\xB2")).contradictions.empty());
}

TEST(FileStatements, AScaleFactorThatConvertsTheFilesUnitIsNoContradiction) {
    const auto with_factor = [](const std::string& unit, double factor) {
        RecordingDescription description = one_channel("r.csv", unit);
        description.channels[0].scale_factor = factor;
        return description;
    };
    Recording recording = loaded("time,a [g]\n" + four_rows, with_factor("m/s^2", 9.81));
    EXPECT_DOUBLE_EQ(recording.series.channels[0].samples[0], 1.5 * 9.81);
    EXPECT_TRUE(recording.contradictions.empty());
    EXPECT_TRUE(loaded("time,a [V]\n" + four_rows, with_factor("m/s^2", 98.0)).contradictions.empty());
    EXPECT_TRUE(loaded("time,a [g]\n" + four_rows, with_factor("g", 1.02)).contradictions.empty());
    recording = loaded("time,a [g]\n" + four_rows, with_factor("", 9.80665));  // as it was written before files spoke
    EXPECT_DOUBLE_EQ(recording.series.channels[0].samples[0], 1.5 * g);
    EXPECT_EQ(loaded("time,a [g]\n" + four_rows, with_factor("m/s^2", 2.0)).contradictions.size(), 1U);
}

TEST(FileStatements, UnitsThatAreNoneOfTheQuantity) {
    const Recording volts = loaded("time,a [V]\n" + four_rows, one_channel("r.csv"));
    ASSERT_EQ(volts.contradictions.size(), 1U);
    EXPECT_EQ(volts.contradictions[0].kind, FaultKind::unknown_scale);
    EXPECT_EQ(volts.series.channels[0].description.scale, Scale::unknown);
    EXPECT_EQ(loaded("time,a [V]\n" + four_rows, one_channel("r.csv", "m/s^2")).contradictions.size(), 1U);
    try {
        loaded("time,a [mm/s]\n" + four_rows, one_channel("r.csv"));
        FAIL();
    } catch (const parameters::ParameterError& error) {
        EXPECT_EQ(error.key(), "channel[1].quantity");
        EXPECT_NE(error.problem().find("'mm/s' (header, line 1), a unit of velocity"), std::string::npos);
    }
}

TEST(FileStatements, ScaleAndOffsetOfTheFile) {
    const ChannelDescription silent{.name = "a"};
    const ColumnStatement packed{
        .unit = "g", .unit_where = "attribute", .scale = 0.01, .offset = 2.0, .scale_where = "attributes"};
    const Conversion own = conversion_of(silent, packed, "channel[1]");
    EXPECT_DOUBLE_EQ(own.factor, 0.01 * g);
    EXPECT_DOUBLE_EQ(own.offset, 2.0 * g);
    EXPECT_FALSE(own.contradiction);
    ChannelDescription stated{.name = "a", .unit = "g", .scale_factor = 0.02};
    const Conversion other = conversion_of(stated, packed, "channel[1]");
    EXPECT_DOUBLE_EQ(other.factor, 0.02 * g);
    ASSERT_TRUE(other.contradiction);
    EXPECT_NE(other.contradiction->says.find("a scale of 0.01 (attributes), the description a scale_factor of 0.02"),
              std::string::npos)
        << other.contradiction->says;
    stated.scale_factor = 0.01;
    EXPECT_FALSE(conversion_of(stated, packed, "channel[1]").contradiction);
    EXPECT_DOUBLE_EQ(conversion_of(stated, packed, "channel[1]").offset, 2.0 * g);
}

TEST(FileStatements, SamplingRatesAndStarts) {
    std::vector<Fault> faults;
    EXPECT_EQ(held_sampling_rate(0.0, 500.0, "header", faults), 500.0);
    EXPECT_EQ(held_sampling_rate(1000.0, 1000.05, "header", faults), 1000.0);
    EXPECT_TRUE(faults.empty());
    EXPECT_EQ(held_sampling_rate(1000.0, 500.0, "line 3", faults), 1000.0);
    ASSERT_EQ(faults.size(), 1U);
    EXPECT_NE(faults[0].says.find("500 Hz (line 3), the description 1000 Hz"), std::string::npos);
    faults.clear();
    hold_columns_together(
        {"a", "b"}, {{.sampling_rate_hz = 500.0, .start_s = 0.0}, {.sampling_rate_hz = 500.0, .start_s = 0.5}}, faults);
    ASSERT_EQ(faults.size(), 1U);
    EXPECT_EQ(faults[0].kind, FaultKind::timing_skew);
    faults.clear();
    hold_columns_together({"a", "b"}, {{.sampling_rate_hz = 500.0}, {.sampling_rate_hz = 1000.0}}, faults);
    ASSERT_EQ(faults.size(), 1U);
    EXPECT_EQ(faults[0].kind, FaultKind::sampling_rate);
}

TEST(FileStatements, RateOfAPreamble) {
    RecordingDescription description = one_channel("r.csv");
    EXPECT_EQ(loaded("Sample rate: 250 Hz\nn,a\n0,1\n1,2.5\n2,3\n", description).series.sampling_rate_hz, 250.0);
    description.sampling_rate_hz = 200.0;
    EXPECT_EQ(loaded("Sample rate: 250 Hz\nn,a\n0,1\n1,2.5\n2,3\n", description).contradictions.size(), 1U);
}

TEST(FileStatements, DensitiesSayTheirUnit) {
    EXPECT_EQ(amplitude_unit("g^2/Hz"), "g");
    EXPECT_EQ(amplitude_unit("g\xC2\xB2/Hz"), "g");
    EXPECT_EQ(amplitude_unit("(m/s^2)^2/Hz"), "m/s^2");
    EXPECT_EQ(amplitude_unit("(mm/s\xC2\xB2)\xC2\xB2/Hz"), "mm/s^2");
    EXPECT_EQ(amplitude_unit("mm^2/s^2/Hz"), "mm/s");
    EXPECT_EQ(amplitude_unit("m^2/s^3"), "m/s^2");
    EXPECT_EQ(amplitude_unit("um^2/Hz"), "um");
    EXPECT_EQ(amplitude_unit("g"), "");
    RecordingDescription description = one_channel("r.csv");
    description.kind = RecordingKind::psd;
    const Recording recording = loaded("frequency_hz,a [g^2/Hz]\n1,2\n2,3\n", description);
    EXPECT_DOUBLE_EQ(recording.spectra[0].psd[0], 2.0 * g * g);
    description.channels[0].unit = "m/s^2";
    EXPECT_EQ(loaded("frequency_hz,a [g^2/Hz]\n1,2\n2,3\n", description).contradictions.size(), 1U);
}

std::string wav_of(const ScratchFolder& folder, const std::string& name, int format) {
    SF_INFO info{};
    info.samplerate = 1000;
    info.channels = 2;
    info.format = SF_FORMAT_WAV | format;
    SNDFILE* sound = sf_open(folder.file(name).c_str(), SFM_WRITE, &info);
    std::vector<double> frames;
    for (int i = 0; i < 4000; ++i) frames.push_back(0.5 * std::sin(0.1 * i));
    sf_writef_double(sound, frames.data(), 2000);
    sf_close(sound);
    return folder.file(name);
}

void write_size(const std::string& file, unsigned size) {
    std::fstream out(file, std::ios::in | std::ios::out | std::ios::binary);
    out.seekp(40);
    for (int i = 0; i < 4; ++i) out.put(static_cast<char>(size >> (8 * i)));
}

RecordingDescription wav_channel() {
    RecordingDescription description = one_channel("a.wav", "m/s^2");
    description.channels[0].column = "1";
    return description;
}

TEST(FileStatements, IntegersOfAWavFileNeedAScale) {
    const ScratchFolder folder;
    wav_of(folder, "a.wav", SF_FORMAT_PCM_16);
    RecordingDescription description = wav_channel();
    const Recording silent = load(description, folder.path());
    ASSERT_EQ(silent.contradictions.size(), 1U);
    EXPECT_EQ(silent.contradictions[0].kind, FaultKind::unknown_scale);
    EXPECT_EQ(silent.contradictions[0].severity, Severity::warning);
    EXPECT_EQ(silent.series.channels[0].description.scale, Scale::unknown);
    description.channels[0].scale_factor = 1.0;
    EXPECT_TRUE(load(description, folder.path()).contradictions.empty());
    wav_of(folder, "a.wav", SF_FORMAT_FLOAT);
    description.channels[0].scale_factor.reset();
    EXPECT_TRUE(load(description, folder.path()).contradictions.empty());
}

TEST(FileStatements, WavFilesWhoseLengthWasNeverWritten) {
    const ScratchFolder folder;
    const std::string file = wav_of(folder, "a.wav", SF_FORMAT_PCM_16);
    const DataTable whole = read_wav(file, {"1"});
    for (const unsigned size : {0U, 0xFFFFFFFFU}) {
        write_size(file, size);
        const DataTable table = read_wav(file, {"1"});
        EXPECT_EQ(table.columns, whole.columns) << size;
        ASSERT_EQ(table.notes.size(), 1U) << size;
        EXPECT_NE(table.notes[0].find("says no length"), std::string::npos);
    }
}

TEST(FileStatements, WavFilesThatWereCutSayBothCounts) {
    const ScratchFolder folder;
    wav_of(folder, "a.wav", SF_FORMAT_PCM_16);
    std::filesystem::resize_file(folder.file("a.wav"), 44 + 4 * 700);
    RecordingDescription description = wav_channel();
    description.channels[0].scale_factor = 20.0;
    const Recording cut = load(description, folder.path());
    EXPECT_EQ(cut.series.size(), 700U);
    ASSERT_EQ(cut.contradictions.size(), 1U);
    EXPECT_NE(cut.contradictions[0].says.find("promises 2000 samples (2 s), 700 are there (0.7 s)"), std::string::npos)
        << cut.contradictions[0].says;
}

TEST(FileStatements, AnEmptyWavFileStaysEmpty) {
    const ScratchFolder folder;
    wav_of(folder, "a.wav", SF_FORMAT_PCM_16);
    write_size(folder.file("a.wav"), 0);
    std::filesystem::resize_file(folder.file("a.wav"), 44);
    EXPECT_THROW(read_wav(folder.file("a.wav"), {}), ReadError);
    std::ofstream(folder.file("a.wav"), std::ios::app | std::ios::binary) << std::string("LIST\4\0\0\0INFO", 12);
    EXPECT_THROW(read_wav(folder.file("a.wav"), {}), ReadError);
}

TEST(KnownUnits, NamesAreSplitFromTheirUnits) {
    EXPECT_EQ(name_with_unit("a [g]").unit, "g");
    EXPECT_EQ(name_with_unit("a (m/s\xC2\xB2)").name, "a");
    EXPECT_EQ(name_with_unit("acc / mm/s^2").unit, "mm/s^2");
    EXPECT_EQ(name_with_unit("a ((m/s^2)^2/Hz)").unit, "(m/s^2)^2/Hz");
    for (const char* whole : {"a", "box (left)", "sensor (T)", "acc (1)", "a [3]", "x, y", "[g]"})
        EXPECT_EQ(name_with_unit(whole).unit, "") << whole;
    EXPECT_EQ(to_si_factor("m/sec^2", ChannelQuantity::acceleration, "k"), 1.0);
    EXPECT_EQ(to_si_factor("m s^-2", ChannelQuantity::acceleration, "k"), 1.0);
    EXPECT_EQ(to_si_factor("m\xC2\xB7s\xE2\x81\xBB\xC2\xB2", ChannelQuantity::acceleration, "k"), 1.0);
}

}  // namespace
}  // namespace railpem::recordings
