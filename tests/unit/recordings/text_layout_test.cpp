// Where the table of a text file begins, and what its columns are called.

#include <gtest/gtest.h>

#include "recordings/files/read_error.hpp"
#include "recordings/files/visible_text.hpp"
#include "recordings/text/read_csv.hpp"
#include "scratch_folder.hpp"

namespace railpem::recordings {
namespace {

using testing::ScratchFolder;
using Numbers = std::vector<double>;

DataTable table_of(const std::string& content, const std::vector<std::string>& wanted) {
    const ScratchFolder folder;
    return read_csv(folder.write("a.csv", content), wanted);
}

void expect_columns(const std::string& content, const std::vector<std::string>& wanted = {"a", "b"}) {
    const DataTable table = table_of(content, wanted);
    EXPECT_EQ(table.columns[0], (Numbers{1.5, -2.25, 3.0})) << content;
    EXPECT_EQ(table.columns[1], (Numbers{10, 20, 30})) << content;
}

const std::string three_rows = "0.0,1.5,10\n0.1,-2.25,20\n0.2,3,30\n";

TEST(TextLayout, PreamblesOfManyKinds) {
    expect_columns("Test: run 12\nDate: 2024-06-07 13:00:00\nSample rate: 10 Hz\n\ntime,a,b\n" + three_rows);
    expect_columns("Test, run 12\nDate, 2024-06-07 13,00,00\nSample rate, 10 Hz\n\ntime,a,b\n" + three_rows);
    expect_columns("Test,run 12,\nRate,10,\nChannels,2,\ntime,a,b\n" + three_rows);  // padded as spreadsheets do
    expect_columns("Line of one word\ntime,a,b\n" + three_rows);
    expect_columns("Run 12 of line A\n5 channels measured\ntime,a,b\ns,g,g\n" + three_rows);
    std::string long_one;
    for (int i = 0; i < 120; ++i) long_one += "Setting " + std::to_string(i) + ": " + std::to_string(i * i) + "\n";
    expect_columns(long_one + "time,a,b\n" + three_rows);
}

TEST(TextLayout, SeveralRowsOfNames) {
    expect_columns("time,a,b\nvertical,vertical,vertical\ns,g,g\n" + three_rows);
    expect_columns("Axle,Axle,Axle\ntime,a,b\ns,g,g\n" + three_rows);
    expect_columns("1st,box front,box rear\ntime,a,b\n" + three_rows);  // the wanted names decide
    expect_columns("s,g,g\ntime,a,b\n" + three_rows);
    const DataTable table =
        table_of("time,a,b\nvertical,lateral,vertical\n[s],[g],[mm/s^2]\n" + three_rows, {"a", "b"});
    EXPECT_EQ(table.says.columns[0].unit, "g");
    EXPECT_EQ(table.says.columns[1].unit, "mm/s^2");
    EXPECT_EQ(table.says.columns[1].unit_where, "row of units, line 3");
}

TEST(TextLayout, LabelsInFrontOfTheHeaderRows) {
    const std::string content =
        "Rate;10;Hz\nName;a;b\nUnit;g;g\nSensitivity;100;100\n0,0;1,5;10\n0,1;-2,25;20\n0,2;3;30\n";
    expect_columns(content);
    const DataTable table = table_of(content, {"1", "a"});
    EXPECT_EQ(table.says.columns[0].unit, "");
    EXPECT_EQ(table.says.columns[1].unit, "g");
}

TEST(TextLayout, CommentsThatAreTheHeader) {
    expect_columns("# time,a,b\n" + three_rows);
    expect_columns("# made by a script\n#time,a,b\n" + three_rows);
    expect_columns("% time a b\n0.0 1.5 10\n0.1 -2.25 20\n0.2 3 30\n");
}

TEST(TextLayout, ExcelsLineOfTheDelimiter) {
    expect_columns("sep=;\r\ntime;a;b\r\n0,0;1,5;10\r\n0,1;-2,25;20\r\n0,2;3;30\r\n");
    expect_columns("\"sep=,\"\ntime,a,b\n" + three_rows);
    expect_columns("sep=|\ntime|a|b\n0.0|1.5|10\n0.1|-2.25|20\n0.2|3|30\n");
}

TEST(TextLayout, LineEndsOfEveryKind) {
    std::string carriage = "time,a,b\n" + three_rows, mixed = "time,a,b\r\n0.0,1.5,10\r0.1,-2.25,20\n0.2,3,30";
    for (char& c : carriage)
        if (c == '\n') c = '\r';
    expect_columns(carriage);
    expect_columns(mixed);
    expect_columns("time,a,b\n\n0.0,1.5,10\n\n0.1,-2.25,20\n\n0.2,3,30\n\n");
}

TEST(TextLayout, CarriageReturnsBeyondOneBuffer) {
    const ScratchFolder folder;
    for (const char* end : {"\r", "\r\n", "\n"}) {
        std::string content = std::string("a,b") + end;
        for (int i = 0; i < 60000; ++i) content += std::to_string(i) + ".25,1" + end;
        const DataTable table = read_csv(folder.write("long.csv", content), {"a"});
        ASSERT_EQ(table.rows(), 60000U);
        for (std::size_t i = 0; i < table.rows(); ++i) ASSERT_EQ(table.columns[0][i], static_cast<double>(i) + 0.25);
    }
}

TEST(TextLayout, RepeatedAndAbsentNamesAreAddressedByOccurrenceOrNumber) {
    expect_columns("time,acc,acc\n" + three_rows, {"acc:1", "acc:2"});
    expect_columns("time,acc,acc\n" + three_rows, {"2", "3"});
    expect_columns("time,,\n" + three_rows, {"2", "3"});
    expect_columns("time,acc [g],acc [g]\n" + three_rows, {"acc:1", "acc:2"});
    expect_columns(three_rows, {"2", "3"});
    expect_columns("Sample rate, 10 Hz\n" + three_rows, {"2", "3"});
    expect_columns("time,3,2\n0.0,1.5,10\n0.1,-2.25,20\n0.2,3,30\n", {"3", "2"});  // names come before numbers
    expect_columns("time,a [m/s^2],b (g)\n" + three_rows);                         // the name without its unit
}

TEST(TextLayout, AmbiguousNamesAreRefusedWithAWayOut) {
    const auto refusal = [](const std::string& content, const std::vector<std::string>& wanted) -> std::string {
        try {
            table_of(content, wanted);
        } catch (const ReadError& error) {
            return error.what();
        }
        return "";
    };
    const std::string twice = refusal("time,acc,acc\n" + three_rows, {"acc"});
    EXPECT_NE(twice.find("there are 2 columns named 'acc'"), std::string::npos) << twice;
    EXPECT_NE(twice.find("column = \"acc:1\", \"acc:2\", or their numbers: \"2\", \"3\""), std::string::npos) << twice;
    EXPECT_NE(refusal(three_rows, {"a"}).find("there is no header, and no column 'a'"), std::string::npos);
    EXPECT_NE(refusal("time,a,b\n" + three_rows, {"4"}).find("there is no column '4'"), std::string::npos);
    EXPECT_NE(refusal("time,a,b\n" + three_rows, {"a", "2"}).find("'a' and '2' are the same column"),
              std::string::npos);
    EXPECT_EQ(refusal("time,a,b,Status,Status\n0,1,2,x,y\n0.1,1,2,x,y\n", {"a", "b"}), "");
}

TEST(TextLayout, PreamblesSayRateUnitAndStart) {
    const ScratchFolder folder;
    const CsvReader reader(folder.write(
        "a.csv", "Start time: 2024-06-07 13:00:00\nSampling frequency (kHz);2,5\nUnit=g\na;b\n1,5;2\n2,5;3\n"));
    EXPECT_EQ(reader.preamble().sampling_rate_hz, 2500.0);
    EXPECT_EQ(reader.preamble().sampling_rate_where, "line 2");
    EXPECT_EQ(reader.preamble().start, "2024-06-07 13:00:00");
    EXPECT_EQ(reader.preamble().unit, "g");
    EXPECT_EQ(CsvReader(folder.write("b.csv", "# dt = 0.002 s\na,b\n1,2\n2,3\n")).preamble().sampling_rate_hz, 500.0);
    EXPECT_EQ(CsvReader(folder.write("c.csv", "Rate of pay: 500\na,b\n1,2\n2,3\n")).preamble().sampling_rate_hz, 0.0);
}

TEST(VisibleText, WritesOutWhatATerminalWouldObey) {
    EXPECT_EQ(visible("run 7\nNo fault\x1B[8m\t\x7F"), "run 7\\nNo fault\\u001b[8m\\t\\u007f");
    EXPECT_EQ(visible("a\xE2\x80\xAE"
                      "b\xC2\x9B"),
              "a\\u202eb\\u009b");
    EXPECT_EQ(visible(std::string_view("a\0b", 3)), "a\\u0000b");
    EXPECT_EQ(visible("m\xC3\xBC\xFFm/s\xC2\xB2 \xE2\x80\x93"), "m\xC3\xBC\\xffm/s\xC2\xB2 \xE2\x80\x93");
    EXPECT_EQ(visible_lines("a\nb\r"), "a\nb\\u000d");
}

}  // namespace
}  // namespace railpem::recordings
