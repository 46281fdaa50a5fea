// Times as files have them.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "parameters/parameter_error.hpp"
#include "recordings/inspection/inspect.hpp"
#include "recordings/loading/load_recording.hpp"
#include "recordings/text/time_stamp.hpp"
#include "scratch_folder.hpp"

namespace railpem::recordings {
namespace {

using testing::ScratchFolder;

constexpr int samples = 2000;

/// A record of one axle box; `time` writes the time of a sample.
Recording record(const std::string& header, const std::function<std::string(int)>& time, double stated_rate = 0.0,
                 const std::string& time_column = "") {
    const ScratchFolder folder;
    std::string content = header + ",a\n";
    for (int i = 0; i < samples; ++i) content += time(i) + fmt::format(",{:.3f}\n", 0.1 * ((i * 7919) % 101 - 50));
    folder.write("r.csv", content);
    RecordingDescription description;
    description.data = "r.csv";
    description.sampling_rate_hz = stated_rate;
    description.time_column = time_column;
    description.channels = {{.name = "a", .location = Location::wheel, .index = 1}};
    return load(description, folder.path());
}

void expect_500_hz(const Recording& recording) {
    EXPECT_NEAR(recording.series.sampling_rate_hz, 500.0, 1e-3);
    ASSERT_EQ(recording.series.time_s.size(), static_cast<std::size_t>(samples));
    EXPECT_NEAR(recording.series.time_s.back() - recording.series.time_s.front(), (samples - 1) / 500.0, 1e-5);
    EXPECT_TRUE(recording.contradictions.empty());
    for (const Fault& fault : inspect(recording, {}).faults)
        EXPECT_TRUE(fault.kind != FaultKind::sampling_jitter && fault.kind != FaultKind::missing_samples &&
                    fault.kind != FaultKind::sampling_rate)
            << fault.says;
}

TEST(FileClock, UnitsThatTheFileNames) {
    for (const char* header : {"Time (ms)", "time [ms]", "time_ms", "t [msec]", "\"Zeit, ms\""})
        expect_500_hz(record(header, [](int i) { return std::to_string(2 * i); }));
    expect_500_hz(record("time [us]", [](int i) { return std::to_string(2000L * i); }));
    expect_500_hz(record("Time (min)", [](int i) { return fmt::format("{:.9f}", i / 30000.0); }));
    expect_500_hz(record("time_s", [](int i) { return fmt::format("{:.3f}", 0.002 * i); }));
}

TEST(FileClock, TheStatedRateTellsTheUnit) {
    expect_500_hz(record(
        "time", [](int i) { return std::to_string(2 * i); }, 500.0));
    expect_500_hz(record(
        "time", [](int i) { return std::to_string(2000L * i); }, 500.0));
    expect_500_hz(record(
        "t", [](int i) { return std::to_string(i); }, 500.0));  // numbers of samples
    expect_500_hz(record(
        "time", [](int i) { return fmt::format("{:.13f}", i / (500.0 * 86400.0)); }, 500.0));
}

TEST(FileClock, WithoutUnitAndRateSlowTimesAreAnError) {
    const Recording recording = record("time", [](int i) { return std::to_string(2 * i); });
    ASSERT_EQ(recording.contradictions.size(), 1U);
    EXPECT_EQ(recording.contradictions[0].kind, FaultKind::sampling_rate);
    EXPECT_EQ(recording.contradictions[0].severity, Severity::error);
    EXPECT_NE(recording.contradictions[0].says.find("in s they make 0.5 Hz and 4000 s, in ms 500 Hz and 4 s"),
              std::string::npos)
        << recording.contradictions[0].says;
}

TEST(FileClock, CountedSince1970) {
    const Recording ms = record("time", [](int i) { return std::to_string(1717765200000L + 2L * i); });
    expect_500_hz(ms);
    EXPECT_EQ(ms.start, "2024-06-07 13:00:00.000 UTC");
    expect_500_hz(
        record("timestamp", [](int i) { return fmt::format("{}.{:03d}", 1717765200 + i / 500, i % 500 * 2); }));
    expect_500_hz(record("time", [](int i) { return std::to_string(1717765200000000000L + 2000000L * i); }));
    expect_500_hz(record("time [ms]", [](int i) { return std::to_string(1717765200000L + 2L * i); }));
    expect_500_hz(record("time", [](int i) { return fmt::format("{:.12f}", 45450.5 + i / (500.0 * 86400.0)); }));
}

TEST(FileClock, DatesAndTimesOfDay) {
    const auto ms = [](int i) { return i % 500 * 2; };
    const Recording iso =
        record("timestamp", [&](int i) { return fmt::format("2024-06-07T13:00:{:02d}.{:03d}Z", i / 500, ms(i)); });
    expect_500_hz(iso);
    EXPECT_EQ(iso.start, "2024-06-07T13:00:00.000Z");
    expect_500_hz(record("time", [&](int i) { return fmt::format("07.06.2024 13:00:{:02d}.{:03d}", i / 500, ms(i)); }));
    expect_500_hz(record("time", [&](int i) { return fmt::format("13:00:{:02d}.{:03d}", i / 500, ms(i)); }));
    expect_500_hz(record("time", [&](int i) { return fmt::format("00:{:02d}.{:03d}", i / 500, ms(i)); }));
    // Over midnight, with a date and without.
    const auto night = [](int i) { return i < 1000 ? 58 + i / 500 : i / 500 - 2; };
    expect_500_hz(record(
        "time", [&](int i) { return fmt::format("{}:{:02d}.{:03d}", i < 1000 ? "23:59" : "00:00", night(i), ms(i)); }));
    expect_500_hz(record("time", [&](int i) {
        return fmt::format("{}:{:02d}.{:03d}", i < 1000 ? "2024-06-30T23:59" : "2024-07-01T00:00", night(i), ms(i));
    }));
    expect_500_hz(record(
        "time_s", [](int i) { return fmt::format("{:.3f}", i < 1000 ? 86398.0 + 0.002 * i : 0.002 * (i - 1000)); }));
}

TEST(FileClock, TextThatIsNoTimeIsLeftAloneWhereNobodyAskedForIt) {
    const Recording recording = record(
        "timestamp", [](int i) { return fmt::format("row {}", i); }, 500.0);
    EXPECT_TRUE(recording.series.time_s.empty());
    ASSERT_EQ(recording.notes.size(), 1U);
    EXPECT_NE(recording.notes[0].find("'timestamp' holds no times"), std::string::npos);
    EXPECT_ANY_THROW(record(
        "timestamp", [](int i) { return fmt::format("row {}", i); }, 500.0, "timestamp"));
}

TEST(FileClock, WholeSecondsNeedAStatedRate) {
    const auto seconds = [](int i) { return std::to_string(i / 50); };
    try {
        record("time", seconds);
        FAIL();
    } catch (const parameters::ParameterError& error) {
        EXPECT_EQ(error.key(), "sampling_rate_hz");
        EXPECT_NE(error.problem().find("several rows share each of them"), std::string::npos);
    }
    const InspectionReport report = inspect(record("time", seconds, 50.0), {});
    int notes = 0;
    for (const Fault& fault : report.faults) {
        EXPECT_TRUE(fault.kind != FaultKind::missing_samples && fault.kind != FaultKind::sampling_rate) << fault.says;
        if (fault.kind != FaultKind::sampling_jitter) continue;
        EXPECT_EQ(fault.severity, Severity::note);
        ++notes;
    }
    EXPECT_EQ(notes, 1);
    // A rate that the stamps contradict is an error still.
    const InspectionReport wrong = inspect(record("time", seconds, 60.0), {});
    EXPECT_TRUE(std::any_of(wrong.faults.begin(), wrong.faults.end(), [](const Fault& fault) {
        return fault.kind == FaultKind::sampling_rate && fault.severity == Severity::error;
    }));
}

TEST(FileClock, TimesRoundedBelowTheIntervalKeepTheRate) {
    const Recording recording = record("time", [](int i) { return fmt::format("{:.3f}", i / 1024.0); });
    EXPECT_NEAR(recording.series.sampling_rate_hz, 1024.0, 0.6);  // one rounding of 1 ms in 2 s
    for (const Fault& fault : inspect(recording, {}).faults) {
        if (fault.kind == FaultKind::too_short) continue;
        EXPECT_NE(fault.severity, Severity::error) << fault.says;
    }
}

TEST(TimeStamp, ReadsWhatLoggersWrite) {
    const auto second = [](const char* text) { return parse_time_stamp(text).value().second; };
    EXPECT_NEAR(second("2024-06-07T13:00:00.002Z"), 46800.002, 1e-9);
    EXPECT_NEAR(second("2024-06-07 13:00:00,002+02:00"), 39600.002, 1e-9);
    EXPECT_NEAR(second("06/07/2024 1:00:00.5 PM"), 46800.5, 1e-9);
    EXPECT_NEAR(second("12:30:00 AM"), 1800.0, 1e-9);
    EXPECT_NEAR(second("01:00.0"), 60.0, 1e-9);
    EXPECT_NEAR(second("01:00"), 3600.0, 1e-9);
    EXPECT_NEAR(second("13:00:00:250"), 46800.25, 1e-9);
    EXPECT_EQ(parse_time_stamp("20240607T130000").value().day, parse_time_stamp("07.06.2024").value().day);
    EXPECT_EQ(parse_time_stamp("25/12/2024").value().day, parse_time_stamp("12/25/2024").value().day);
    for (const char* text : {"", "1.5", "20240607", "13", "1:2:3:4:5", "2024-13-01", "25:61", "run 12", "1.234.567,8"})
        EXPECT_FALSE(parse_time_stamp(text)) << text;
}

}  // namespace
}  // namespace railpem::recordings
