#include "app/schema/recording_schema.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "file_text.hpp"

namespace railpem::app {
namespace {

namespace fs = std::filesystem;

TEST(RecordingSchema, PageIsUpToDate) {
    EXPECT_EQ(testing::file_text(fs::path(RAILPEM_SOURCE_DIR) / "docs/recording.md"), describe_recording())
        << "run: railpem describe recording > docs/recording.md";
}

TEST(RecordingSchema, FolderAndFileMeanTheSame) {
    std::string name = (fs::temp_directory_path() / "railpem_schema_XXXXXX").string();
    const fs::path folder = mkdtemp(name.data());
    std::ofstream(folder / "recording.toml")
        << "speed_m_per_s = 20\ndata = \"recording.wav\"\n[[channel]]\nname = \"a\"\nquantity = \"velocity\"\nlocation "
           "= \"body\"\nposition_m = -9\n";
    const RecordingFile by_folder = read_recording(folder.string()),
                        by_file = read_recording((folder / "recording.toml").string());
    fs::remove_all(folder);
    for (const RecordingFile& file : {by_folder, by_file}) {
        EXPECT_EQ(file.name, folder.filename().string());
        EXPECT_EQ(file.base, folder);
        ASSERT_EQ(file.description.channels.size(), 1u);
        EXPECT_EQ(file.description.channels[0].quantity, recordings::ChannelQuantity::velocity);
        EXPECT_EQ(file.description.channels[0].position_m, -9.0);
        EXPECT_EQ(file.description.speed_m_per_s, 20.0);
        EXPECT_TRUE(file.states("speed_m_per_s"));
        EXPECT_FALSE(file.states("payload_kg"));
    }
}

}  // namespace
}  // namespace railpem::app
