// What the attributes and the storage of an HDF5 file add to its numbers.

#include <gtest/gtest.h>
#include <hdf5.h>

#include <cmath>

#include "recordings/files/read_binary.hpp"
#include "recordings/files/read_error.hpp"
#include "recordings/loading/load_recording.hpp"
#include "scratch_folder.hpp"

namespace railpem::recordings {
namespace {

using testing::ScratchFolder;

/// A file while it is written.
class Writing {
  public:
    explicit Writing(const std::string& file)
        : root_(H5Fcreate(file.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT)) {}
    ~Writing() { H5Fclose(root_); }
    Writing(const Writing&) = delete;
    Writing& operator=(const Writing&) = delete;
    hid_t root() const { return root_; }

    hid_t dataset(const char* name, const std::vector<short>& values, hid_t creation = H5P_DEFAULT) {
        const hsize_t size = values.size();
        const hid_t space = H5Screate_simple(1, &size, nullptr), links = H5Pcreate(H5P_LINK_CREATE);
        H5Pset_create_intermediate_group(links, 1);
        const hid_t data = H5Dcreate2(root_, name, H5T_STD_I16BE, space, links, creation, H5P_DEFAULT);
        if (creation == H5P_DEFAULT) H5Dwrite(data, H5T_NATIVE_SHORT, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
        H5Pclose(links);
        H5Sclose(space);
        return data;
    }

  private:
    hid_t root_;
};

void attach(hid_t object, const char* name, double value) {
    const hid_t space = H5Screate(H5S_SCALAR);
    const hid_t attribute = H5Acreate2(object, name, H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, H5P_DEFAULT);
    H5Awrite(attribute, H5T_NATIVE_DOUBLE, &value);
    H5Aclose(attribute);
    H5Sclose(space);
}

void attach(hid_t object, const char* name, const char* text) {
    const hid_t space = H5Screate(H5S_SCALAR), type = H5Tcopy(H5T_C_S1);
    H5Tset_size(type, H5T_VARIABLE);
    const hid_t attribute = H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT);
    H5Awrite(attribute, type, &text);
    H5Aclose(attribute);
    H5Tclose(type);
    H5Sclose(space);
}

RecordingDescription described(const std::string& data, const std::string& column, const std::string& unit) {
    RecordingDescription d;
    d.data = data;
    d.sampling_rate_hz = 500.0;
    d.channels = {{.name = "a", .column = column, .unit = unit, .location = Location::wheel, .index = 1}};
    return d;
}

std::string refusal(const std::string& file, const std::string& wanted) {
    try {
        read_hdf5(file, {wanted}, {.seconds = 5.0});
    } catch (const ReadError& error) {
        return error.problem();
    }
    return "accepted";
}

TEST(Hdf5, PackedNumbersAreUnpackedAndTheirUnitIsUsed) {
    const ScratchFolder folder;
    {
        Writing file(folder.file("a.h5"));
        const hid_t data = file.dataset("Measurement/Ch 1/data", {1000, 2000, -32768, 4000});
        attach(data, "scale_factor", 0.001);
        attach(data, "add_offset", 0.5);
        attach(data, "_FillValue", -32768.0);
        attach(data, "units", "g");
        H5Dclose(data);
    }
    const auto samples = [&](const std::string& unit) {
        return load(described("a.h5", "Measurement/Ch 1/data", unit), folder.path()).series.channels[0].samples;
    };
    EXPECT_NEAR(samples("")[1], 2.5 * 9.80665, 1e-12);
    EXPECT_TRUE(std::isnan(samples("")[2]));
    EXPECT_NEAR(samples("g")[3], 4.5 * 9.80665, 1e-12);
    const Recording other = load(described("a.h5", "Measurement/Ch 1/data", "m/s^2"), folder.path());
    ASSERT_EQ(other.contradictions.size(), 1U);  // one message that names both
    EXPECT_NE(other.contradictions[0].says.find("'g' (attribute 'units')"), std::string::npos);
    EXPECT_NE(other.contradictions[0].says.find("'m/s^2'"), std::string::npos);
}

TEST(Hdf5, TheGroupOfAChannelSpeaksForIt) {
    const ScratchFolder folder;
    {
        Writing file(folder.file("a.h5"));
        H5Dclose(file.dataset("Ch 1/data", {1, 2, 3}));
        const hid_t group = H5Gopen2(file.root(), "Ch 1", H5P_DEFAULT);
        attach(group, "unit_string", "mm/s^2");
        attach(group, "wf_increment", 0.004);
        H5Gclose(group);
    }
    const DataTable table = read_hdf5(folder.file("a.h5"), {"Ch 1/data"});
    EXPECT_EQ(table.sampling_rate_hz, 250.0);
    EXPECT_EQ(table.says.columns[0].unit, "mm/s^2");
    EXPECT_EQ(table.says.columns[0].sampling_rate_hz, 250.0);
}

TEST(Hdf5, ACalibrationThatIsNotAppliedIsNamed) {
    const ScratchFolder folder;
    {
        Writing file(folder.file("a.h5"));
        const hid_t data = file.dataset("a", {1, 2, 3});
        attach(data, "gain", 4.0);
        H5Dclose(data);
    }
    const DataTable table = read_hdf5(folder.file("a.h5"), {"a"});
    ASSERT_EQ(table.notes.size(), 1U);
    EXPECT_NE(table.notes[0].find("'gain' = 4"), std::string::npos);
}

TEST(Hdf5, NumbersOfOtherFilesAreNotRead) {
    const ScratchFolder folder;
    folder.write("other.bin", std::string(64, 'x'));
    {
        Writing file(folder.file("a.h5"));
        const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
        H5Pset_external(creation, folder.file("other.bin").c_str(), 0, 64);
        H5Dclose(file.dataset("outside", std::vector<short>(32), creation));
        H5Pclose(creation);
        H5Lcreate_external(folder.file("b.h5").c_str(), "/x", file.root(), "elsewhere", H5P_DEFAULT, H5P_DEFAULT);
        H5Dclose(file.dataset("own", {1, 2, 3}));
    }
    EXPECT_NE(refusal(folder.file("a.h5"), "outside").find("keeps its numbers in another file"), std::string::npos);
    EXPECT_EQ(refusal(folder.file("a.h5"), "elsewhere"), "'elsewhere' is a link into another file");
    EXPECT_EQ(refusal(folder.file("a.h5"), "elsewhere/x"), "'elsewhere' is a link into another file");
    EXPECT_EQ(refusal(folder.file("a.h5"), "own"), "accepted");
}

TEST(Hdf5, NamesThatAreNotUtf8AreRead) {
    const ScratchFolder folder;
    {
        Writing file(folder.file("a.h5"));
        H5Dclose(
            file.dataset("B\xFC"
                         "gel",
                         {1, 2, 3}));
    }
    EXPECT_EQ(read_hdf5(folder.file("a.h5"), {"B\xC3\xBCgel"}).rows(), 3U);
    EXPECT_EQ(refusal(folder.file("a.h5"), "Bugel"), "there is no dataset 'Bugel'");
}

TEST(Hdf5, BlocksAddUpToTheWhole) {
    const ScratchFolder folder;
    {
        Writing file(folder.file("a.h5"));
        const hsize_t size[] = {50, 3};
        std::vector<double> x(150);
        for (std::size_t i = 0; i < x.size(); ++i) x[i] = static_cast<double>(i);
        const hid_t space = H5Screate_simple(2, size, nullptr);
        const hid_t data =
            H5Dcreate2(file.root(), "d", H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
        H5Dwrite(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, x.data());
        H5Dclose(data);
        H5Sclose(space);
    }
    std::vector<std::vector<double>> joined(3);
    const std::vector<std::string> wanted = {"d:2", "d:3", "d:1"};
    read_hdf5_blocks(folder.file("a.h5"), wanted, 16, {}, [&](DataTable& block) {
        for (std::size_t i = 0; i < 3; ++i)
            joined[i].insert(joined[i].end(), block.columns[i].begin(), block.columns[i].end());
    });
    EXPECT_EQ(joined, read_hdf5(folder.file("a.h5"), wanted).columns);
    EXPECT_EQ(joined[0][1], 4.0);
    EXPECT_EQ(joined[2].size(), 50U);
}

}  // namespace
}  // namespace railpem::recordings
