// Numbers as text files have them: decimal signs, thousands, words for missing samples.

#include <gtest/gtest.h>

#include <cmath>

#include "recordings/files/read_error.hpp"
#include "recordings/text/missing_words.hpp"
#include "recordings/text/read_csv.hpp"
#include "scratch_folder.hpp"

namespace railpem::recordings {
namespace {

using testing::ScratchFolder;
using Numbers = std::vector<double>;

Numbers column_a(const std::string& content) {
    const ScratchFolder folder;
    return read_csv(folder.write("a.csv", content), {"a"}).columns[0];
}

TEST(TextNumbers, PointsBetweenThousandsAreNotDecimals) {
    EXPECT_EQ(column_a("t;a\n0,000;1.234,56\n0,002;-11,55\n0,004;1.234.567,8\n"),
              (Numbers{1234.56, -11.55, 1234567.8}));
    EXPECT_EQ(column_a("t;a\n0,000;-1.341\n0,002;12\n0,004;126\n"), (Numbers{-1341, 12, 126}));
    EXPECT_EQ(column_a("t;a\n0.5;1,234.56\n1.0;12.5\n"), (Numbers{1234.56, 12.5}));
    EXPECT_EQ(column_a("t,a\n0.5,\"1,234.56\"\n1.0,12.5\n"), (Numbers{1234.56, 12.5}));
}

TEST(TextNumbers, BlanksAndApostrophesBetweenThousands) {
    EXPECT_EQ(column_a("t;a\n0,5;1 234,56\n1,0;-12 345,6\n"), (Numbers{1234.56, -12345.6}));
    EXPECT_EQ(column_a("t;a\n0,5;1\xC2\xA0\x32\x33\x34,5\n1,0;1\xE2\x80\xAF\x32\x33\x34,5\n"),
              (Numbers{1234.5, 1234.5}));
    EXPECT_EQ(column_a("t;a\n0.5;1'234.56\n1.0;12.5\n"), (Numbers{1234.56, 12.5}));
}

TEST(TextNumbers, WholeNumbersBesideThreeDecimalsAreThousands) {
    const std::string some = "1.234\n2.345\n999\n3.456\n4.567\n5.678\n6.789\n7.891\n8.912\n12\n";
    EXPECT_EQ(column_a("a\n" + some), (Numbers{1234, 2345, 999, 3456, 4567, 5678, 6789, 7891, 8912, 12}));
    // One number that cannot be a group tells that the others are none.
    EXPECT_EQ(column_a("a\n" + some + "0.25\n")[0], 1.234);
    EXPECT_EQ(column_a("a\n" + some + "1.5\n")[2], 999.0);
    // Decimals in full everywhere are decimals, and so are a few numbers of which nothing can be told.
    EXPECT_EQ(column_a("a\n1.234\n2.345\n12.000\n3.456\n4.567\n5.678\n6.789\n7.891\n8.912\n")[0], 1.234);
    EXPECT_EQ(column_a("a\n1.234\n999\n")[0], 1.234);
}

TEST(TextNumbers, ThousandsThatShowLateAreRefused) {
    std::string content = "a\n";
    for (int i = 0; i < 2000; ++i) content += std::to_string(i % 1000) + "\n";
    for (int i = 0; i < 20; ++i) content += "1.00" + std::to_string(i % 10) + "\n";
    try {
        column_a(content);
        FAIL();
    } catch (const ReadError& error) {
        EXPECT_NE(
            std::string(error.what()).find("'1.000' in column 'a' may be a number of three decimals or thousands"),
            std::string::npos)
            << error.what();
        EXPECT_GT(error.line(), 2001U);
    }
}

TEST(TextNumbers, QuotedDecimalCommas) {
    EXPECT_EQ(column_a("t,a\n\"0,000\",\"1,5\"\n\"0,002\",\"-2,25\"\n"), (Numbers{1.5, -2.25}));
    EXPECT_EQ(column_a("t,a,n\n\"0,000\",\"1,5\",1\n\"0,002\",2,1\n"), (Numbers{1.5, 2}));
}

TEST(TextNumbers, OtherSpellings) {
    EXPECT_EQ(column_a("a,b\n\xE2\x88\x92"
                       "1.5,1\n1.5D+02,1\n+2,1\n"),
              (Numbers{-1.5, 150, 2}));
}

TEST(TextNumbers, AWordColumnDoesNotHideTheDecimalComma) {
    EXPECT_EQ(column_a("t;Status;a\n0,000;OK;1,5\n0,002;OK;-2,25\n"), (Numbers{1.5, -2.25}));
}

TEST(TextNumbers, WordsForMissingSamples) {
    for (const char* word :
         {"NaN",     "-nan",      "+NAN",   "nan(ind)", "-nan(ind)", "NA",  "#N/A", "#NV",      "n/a",     "-1.#IND",
          "1.#QNAN", "-1.#IND00", "1.#INF", "Inf",      "-Infinity", "OVL", "ovr",  "Overload", "#DIV/0!", "#VALUE!",
          "null",    "None",      "---",    "-",        "-.--",      "***", "?",    "<NA>",     "No Data"}) {
        EXPECT_TRUE(is_missing_word(word)) << word;
        const ScratchFolder folder;
        const DataTable table =
            read_csv(folder.write("a.csv", std::string("a,b\n1.5,1\n") + word + ",2\n2.5,3\n"), {"a", "b"});
        EXPECT_EQ(table.columns[1], (Numbers{1, 2, 3})) << word;
        EXPECT_TRUE(std::isnan(table.columns[0][1])) << word;
        ASSERT_EQ(table.notes.size(), 1U) << word;
        EXPECT_EQ(table.notes[0], std::string("'") + word + "' stands in 1 field: read as missing samples");
    }
    for (const char* word : {"", "four", "1.5", "-1", "x", ".", "1.#X", "nano"})
        EXPECT_FALSE(is_missing_word(word)) << word;
}

TEST(TextNumbers, OtherWordsAreRefusedWithThoseThatAreKnown) {
    try {
        column_a("a,b\n1,2\nfour,3\n5,6\n");
        FAIL();
    } catch (const ReadError& error) {
        EXPECT_EQ(error.line(), 3U);
        EXPECT_NE(error.allowed().find("#N/A"), std::string::npos);
    }
}

}  // namespace
}  // namespace railpem::recordings
