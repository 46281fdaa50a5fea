#include "app/output_folder.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "file_text.hpp"

namespace railpem::app {
namespace {

namespace fs = std::filesystem;

class OutputFolderTest : public ::testing::Test {
  protected:
    void SetUp() override {
        std::string name = (fs::temp_directory_path() / "railpem-output-XXXXXX").string();
        ASSERT_NE(::mkdtemp(name.data()), nullptr);
        root_ = name;
    }
    void TearDown() override { fs::remove_all(root_); }
    static std::size_t count(const fs::path& folder) {
        return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), {}));
    }
    fs::path root_;
};

TEST_F(OutputFolderTest, ShowsNothingBeforeTheCommit) {
    OutputFolder folder(root_ / "a/b");
    folder.write("one.csv", "1\n");
    EXPECT_FALSE(fs::exists(root_ / "a/b/one.csv"));
    folder.write("two.csv", "2\n");
    folder.commit();
    EXPECT_EQ(testing::file_text(root_ / "a/b/one.csv"), "1\n");
    EXPECT_EQ(testing::file_text(root_ / "a/b/two.csv"), "2\n");
    EXPECT_EQ(count(root_ / "a/b"), 2u);
}

TEST_F(OutputFolderTest, TakesAllBackWithoutACommit) {
    {
        OutputFolder folder(root_ / "a/b");
        folder.write("one.csv", "1\n");
    }
    EXPECT_EQ(count(root_), 0u);
}

TEST_F(OutputFolderTest, LeavesWhatWasThereBefore) {
    fs::create_directory(root_ / "a");
    std::ofstream(root_ / "a/one.csv") << "old";
    {
        OutputFolder folder(root_ / "a");
        folder.write("one.csv", "new");
    }
    EXPECT_EQ(testing::file_text(root_ / "a/one.csv"), "old");
    OutputFolder folder(root_ / "a");
    folder.write("one.csv", "new");
    folder.commit();
    EXPECT_EQ(testing::file_text(root_ / "a/one.csv"), "new");
    EXPECT_EQ(count(root_ / "a"), 1u);
}

}  // namespace
}  // namespace railpem::app
