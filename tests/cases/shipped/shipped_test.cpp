// Every shipped case through the program, against the outputs that are kept beside it (scripts/update_expected.sh
// writes them anew).

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> shipped_cases() {
    std::vector<fs::path> cases;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(fs::path(RAILPEM_SOURCE_DIR) / "cases")) {
        const std::string name = entry.path().filename().string();
        if (entry.path().extension() == ".toml" && !name.ends_with(".sweep.toml") && name != "recording.toml")
            cases.push_back(entry.path());
    }
    std::sort(cases.begin(), cases.end());
    return cases;
}

struct Csv {
    std::string header;
    std::vector<std::vector<double>> rows;
};

Csv read_csv(const fs::path& path) {
    std::ifstream file(path);
    Csv csv;
    std::getline(file, csv.header);
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with('#')) continue;  // where it comes from
        std::istringstream cells(line);
        csv.rows.emplace_back();
        for (std::string cell; std::getline(cells, cell, ',');)
            csv.rows.back().push_back(std::strtod(cell.c_str(), nullptr));
    }
    return csv;
}

/// Other compilers and processors round differently: the tables carry nine digits, levels in dB. A hundredfold of that.
void expect_same(const fs::path& expected, const fs::path& computed) {
    const Csv a = read_csv(expected), b = read_csv(computed);
    ASSERT_FALSE(a.rows.empty()) << expected << " is missing: scripts/update_expected.sh";
    EXPECT_EQ(a.header, b.header);
    ASSERT_EQ(a.rows.size(), b.rows.size()) << computed;
    for (std::size_t row = 0; row < a.rows.size(); ++row) {
        ASSERT_EQ(a.rows[row].size(), b.rows[row].size());
        for (std::size_t column = 0; column < a.rows[row].size(); ++column) {
            if (std::isinf(a.rows[row][column]) && a.rows[row][column] == b.rows[row][column]) continue;
            EXPECT_NEAR(b.rows[row][column], a.rows[row][column], 1e-7 * std::abs(a.rows[row][column]) + 1e-12)
                << computed << " row " << row + 2 << " column " << column + 1;
        }
    }
}

TEST(ShippedCases, AgreeWithTheirExpectedOutputs) {
    ASSERT_GE(shipped_cases().size(), 5u);
    std::string folder = (fs::temp_directory_path() / "railpem_shipped_XXXXXX").string();
    ASSERT_NE(mkdtemp(folder.data()), nullptr);
    for (const fs::path& path : shipped_cases()) {
        const std::string program = std::string("\"") + RAILPEM_PROGRAM + "\" ";
        ASSERT_EQ(std::system((program + "solve " + path.string() + " --bands --out " + folder).c_str()), 0) << path;
        ASSERT_EQ(std::system((program + "static " + path.string() + " --out " + folder).c_str()), 0) << path;
        const std::string name = path.stem().string();
        for (const char* ending : {".bands.csv", ".static.csv"})
            expect_same(path.parent_path() / "expected" / (name + ending), fs::path(folder) / (name + ending));
    }
    fs::remove_all(folder);
}

}  // namespace
