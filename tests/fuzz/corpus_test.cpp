// Every kept input, fed to its reader: it is read, or refused in words. Inputs at which a library stops the process
// that reads them are kept apart and go through the program's own reading, which must survive them.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "feed.hpp"

namespace railpem::fuzz {
namespace {

namespace fs = std::filesystem;

const fs::path folder = fs::path(RAILPEM_SOURCE_DIR) / "tests/fuzz";

std::vector<char> bytes_of(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

class Corpus : public ::testing::TestWithParam<std::string> {};

TEST_P(Corpus, IsReadOrRefusedInWords) {
    int files = 0, read = 0;
    for (const auto& entry : fs::directory_iterator(folder / "corpus" / GetParam())) {
        ++files;
        try {
            read += feed(GetParam(), bytes_of(entry.path()), Libraries::in_child) ? 1 : 0;
        } catch (const std::exception& error) {
            ADD_FAILURE() << entry.path() << ": " << error.what();
        }
    }
    EXPECT_GE(files, 1);
    // A sweep names a case beside it, and there is none beside a file in memory.
    EXPECT_GE(read, GetParam() == "sweep" ? 0 : 1) << "no input of this kind is sound: the corpus does not reach far";
}

INSTANTIATE_TEST_SUITE_P(Readers, Corpus, ::testing::ValuesIn(input_kinds()),
                         [](const auto& kind) { return kind.param; });

TEST(LibraryCrashes, AreRefusalsOfTheProgram) {
    int files = 0;
    for (const auto& entry : fs::directory_iterator(folder / "library_crashes")) {
        ++files;
        const std::string ending = entry.path().extension().string();
        const std::string kind = ending == ".mat" ? "mat" : ending == ".h5" ? "hdf5" : "wav";
        EXPECT_FALSE(feed(kind, bytes_of(entry.path()), Libraries::in_child)) << entry.path();
    }
    EXPECT_GE(files, 1);
}

}  // namespace
}  // namespace railpem::fuzz
