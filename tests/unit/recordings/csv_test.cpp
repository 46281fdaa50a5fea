#include <gtest/gtest.h>
#include <sys/resource.h>
#include <zlib.h>

#include <chrono>
#include <cmath>

#include "recordings/files/read_error.hpp"
#include "recordings/loading/write_csv.hpp"
#include "recordings/text/read_csv.hpp"
#include "scratch_folder.hpp"

namespace railpem::recordings {
namespace {

using testing::ScratchFolder;

const std::vector<double> expected_a = {1.5, -2.25, 3e-3};

void expect_read(const std::string& content, const std::string& name = "a.csv") {
    const ScratchFolder folder;
    const DataTable table = read_csv(folder.write(name, content), {"b", "a"});
    ASSERT_EQ(table.names, (std::vector<std::string>{"b", "a"}));
    EXPECT_EQ(table.columns[1], expected_a) << content;
    EXPECT_EQ(table.columns[0], (std::vector<double>{10.0, 20.0, 30.0})) << content;
}

TEST(Csv, DelimitersDecimalSignsAndLineEnds) {
    expect_read("a,b\n1.5,10\n-2.25,20\n3e-3,30\n");
    expect_read("a,b\r\n1.5,10\r\n-2.25,20\r\n3e-3,30");
    expect_read("a;b\n1,5;10\n-2,25;20\n3e-3;30\n");
    expect_read("a;b\n1.5;10\n-2.25;20\n0.003;30\n");
    expect_read("a\tb\n1,5\t10\n-2,25\t20\n0,003\t30\n");
    expect_read("a\tb\n1.5\t10\n-2.25\t20\n0.003\t30\n");
    expect_read("a b\n1.5  10\n  -2.25 20\n0.003 30\n");
    expect_read("a, b\n 1.5, 10\n -2.25, 20\n +0.003, 30\n");
    expect_read("\"a\",\"b\"\n\"1.5\",10\n-2.25,20\n0.003,\"30\"\n");
    expect_read("a;b;\n1,5;10;\n-2,25;20;\n0,003;30;\n");
}

TEST(Csv, CommentsMarksAndUnits) {
    expect_read("# measured on a Tuesday\n\n% and a comment\na,b\n1.5,10\n# in between\n\n-2.25,20\n3e-3,30\n");
    expect_read(
        "\xEF\xBB\xBF"
        "a,b\n1.5,10\n-2.25,20\n3e-3,30\n");
    expect_read("a,b\nm/s^2,g\n1.5,10\n-2.25,20\n3e-3,30\n");
    const ScratchFolder folder;
    const DataTable table = read_csv(folder.write("a.csv", "a,b\nm/s^2,g\n1.5,10\n"));
    EXPECT_TRUE(table.notes.empty());
    EXPECT_EQ(table.says.columns[0].unit, "m/s^2");
    EXPECT_EQ(table.says.columns[1].unit, "g");
}

TEST(Csv, GzipAndLatin1) {
    const ScratchFolder folder;
    const gzFile out = gzopen(folder.file("a.csv.gz").c_str(), "wb");
    const std::string content = "a,b\n1.5,10\n-2.25,20\n3e-3,30\n";
    gzwrite(out, content.data(), static_cast<unsigned>(content.size()));
    gzclose(out);
    EXPECT_EQ(read_csv(folder.file("a.csv.gz"), {"a"}).columns[0], expected_a);
    const DataTable latin = read_csv(folder.write("l.csv", "Beschleunigung in m/s\xB2;b\n1,5;2\n"));
    EXPECT_EQ(latin.names[0], "Beschleunigung in m/s\xC2\xB2");
    EXPECT_EQ(latin.notes.size(), 1U);
}

TEST(Csv, EmptyFieldsAreMissing) {
    const ScratchFolder folder;
    const DataTable table = read_csv(folder.write("a.csv", "a,b\n1,2\n,3\nNaN,4\nn/a,5\n"));
    for (std::size_t i = 1; i < 4; ++i) EXPECT_TRUE(std::isnan(table.columns[0][i]));
    EXPECT_EQ(table.columns[1].back(), 5.0);
}

struct Refusal {
    const char* content;
    std::size_t line;
    const char* words;
};

TEST(Csv, RefusesWithLineAndProblem) {
    const std::string wide(1200000, 'x');
    const std::string long_line = "a,b\n1,2\n" + wide;
    const Refusal refusals[] = {
        {"", 0, "empty"},
        {"# only\n# comments\n", 0, "comments only"},
        {"a,b\n1,2\n3\n4,5\n", 3, "1 fields where the header has 2"},
        {"a,b\n1,2\n3,4,5\n", 3, "3 fields where the header has 2"},
        {"a,b,c\n1,2,3\n4,5", 3, "stops in the middle of a row"},
        {"a,b\n1,2\n3,four\n5,6\n", 3, "'four' in column 'b' is not a number"},
        {"a,b\n1,2\n3,1e999\n", 3, "is not a number"},
        {"a;b\n1,5;2\n1,6;2\n3.5;4\n", 4, "decimal comma"},
        {"1,2\n3,4\n", 1, "there is no header"},
        {"a,b\n", 1, "no row of numbers"},
        {"\xFF\xFE"
         "a\n1\n",
         1, "UTF-16"},
        {long_line.c_str(), 3, "a line of more than"},
    };
    const ScratchFolder folder;
    for (const Refusal& refusal : refusals) {
        try {
            read_csv(folder.write("a.csv", refusal.content));
            ADD_FAILURE() << refusal.words;
        } catch (const ReadError& error) {
            EXPECT_EQ(error.line(), refusal.line) << error.what();
            EXPECT_NE(std::string(error.what()).find(refusal.words), std::string::npos) << error.what();
            EXPECT_FALSE(error.allowed().empty());
            EXPECT_EQ(error.file(), folder.file("a.csv"));
        }
    }
    EXPECT_THROW(read_csv(folder.write("zero.csv", std::string("a,b\n1,\0\n", 8))), ReadError);
    EXPECT_THROW(read_csv(folder.file("absent.csv")), ReadError);
    EXPECT_THROW(read_csv(folder.path().string()), ReadError);
}

TEST(Csv, RefusesATruncatedGzipFile) {
    const ScratchFolder folder;
    const gzFile out = gzopen(folder.file("a.csv.gz").c_str(), "wb");
    std::string content = "a,b\n";
    for (int i = 0; i < 5000; ++i) content += std::to_string(i * 7919 % 10007) + ".5," + std::to_string(i) + "\n";
    gzwrite(out, content.data(), static_cast<unsigned>(content.size()));
    gzclose(out);
    const auto size = std::filesystem::file_size(folder.file("a.csv.gz"));
    for (const auto left : {size / 2, size - 9, size - 1}) {
        std::filesystem::resize_file(folder.file("a.csv.gz"), left);
        EXPECT_THROW(read_csv(folder.file("a.csv.gz")), ReadError) << left;
    }
}

TEST(Csv, NamesTheNearestColumn) {
    const ScratchFolder folder;
    try {
        read_csv(folder.write("a.csv", "time_s,axlebox_1,axlebox_2\n0,1,2\n"), {"axelbox_1"});
        FAIL();
    } catch (const ReadError& error) {
        EXPECT_NE(std::string(error.what()).find("did you mean 'axlebox_1'"), std::string::npos) << error.what();
        EXPECT_EQ(error.line(), 1U);
    }
}

TEST(Csv, ReadsBackExactlyWhatItWrote) {
    const ScratchFolder folder;
    DataTable table;
    table.names = {"time_s", "odd, name"};
    table.columns = {{0.0, 0.001, 0.002}, {1.0 / 3.0, std::nan(""), -1.2345678901234567e-300}};
    write_csv(folder.file("a.csv"), table);
    const DataTable back = read_csv(folder.file("a.csv"));
    EXPECT_EQ(back.names, table.names);
    EXPECT_EQ(back.columns[0], table.columns[0]);
    EXPECT_EQ(back.columns[1][0], table.columns[1][0]);
    EXPECT_TRUE(std::isnan(back.columns[1][1]));
    EXPECT_EQ(back.columns[1][2], table.columns[1][2]);
    EXPECT_THROW(write_csv(folder.file("no/such/folder.csv"), table), ReadError);
}

TEST(Csv, ReadsSectionsInTheMemoryOfOne) {
    // 60 MB of text in sections of 1000 rows: the peak of resident memory may grow by a few buffers only.
    const ScratchFolder folder;
    {
        std::ofstream out(folder.file("long.csv"), std::ios::binary);
        out << "a,b,c,d,e,f,g,h\n";
        std::string block;
        for (int row = 0; row < 1000; ++row)
            block += "-1.23456,2.34567,3.45678,-4.56789,5.67891,6.78912,-7.89123,8.91234\n";
        for (int i = 0; i < 900; ++i) out << block;
    }
    const auto peak_kilobytes = [] {
        rusage usage{};
        getrusage(RUSAGE_SELF, &usage);
        return usage.ru_maxrss;
    };
    const long before = peak_kilobytes();
    CsvReader reader(folder.file("long.csv"));
    std::vector<std::vector<double>> columns(8);
    std::size_t rows = 0;
    while (const std::size_t got = reader.read(1000, columns)) {
        rows += got;
        for (auto& column : columns) column.clear();
    }
    EXPECT_EQ(rows, 900000U);
    EXPECT_LT(peak_kilobytes() - before, 8000);
}

}  // namespace
}  // namespace railpem::recordings
