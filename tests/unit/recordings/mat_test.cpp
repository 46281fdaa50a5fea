// What MATLAB and other programs put into a .mat file beside plain matrices.

#include <gtest/gtest.h>
#include <hdf5.h>
#include <matio.h>

#include <cmath>
#include <fstream>

#include "recordings/files/read_binary.hpp"
#include "recordings/files/read_error.hpp"
#include "scratch_folder.hpp"

namespace railpem::recordings {
namespace {

using testing::ScratchFolder;

constexpr std::size_t mat_rows = 40;

/// A column of `mat_rows` numbers that begin at `first`.
matvar_t* column(const char* name, double first) {
    std::vector<double> x;
    for (std::size_t i = 0; i < mat_rows; ++i) x.push_back(first + static_cast<double>(i));
    std::size_t sizes[] = {mat_rows, 1};
    return Mat_VarCreate(name, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, sizes, x.data(), 0);
}

void put(mat_t* mat, matvar_t* variable, matio_compression compression) {
    Mat_VarWrite(mat, variable, compression);
    Mat_VarFree(variable);
}

matvar_t* array_of_structures() {
    const char* fields[] = {"y", "name"};
    const char* inner[] = {"values"};
    std::size_t two[] = {1, 2}, one[] = {1, 1}, letters[] = {1, 3};
    matvar_t* signal = Mat_VarCreateStruct("Signal", 2, two, fields, 2);
    for (std::size_t i = 0; i < 2; ++i) {
        matvar_t* y = Mat_VarCreateStruct(nullptr, 2, one, inner, 1);
        Mat_VarSetStructFieldByName(y, "values", 0, column(nullptr, 100.0 * static_cast<double>(i + 1)));
        Mat_VarSetStructFieldByName(signal, "y", i, y);
        char name[] = "abc";
        Mat_VarSetStructFieldByName(signal, "name", i,
                                    Mat_VarCreate(nullptr, MAT_C_CHAR, MAT_T_UTF8, 2, letters, name, 0));
    }
    return signal;
}

void write_containers(const std::string& file, mat_ft version, matio_compression compression) {
    mat_t* mat = Mat_CreateVer(file.c_str(), nullptr, version);
    std::size_t two[] = {1, 2}, wide[] = {2, mat_rows}, long_sides[] = {mat_rows, 1}, nothing[] = {0, 0},
                one[] = {1, 1};
    matvar_t* cells[] = {column(nullptr, 1.0), column(nullptr, 2.0)};
    put(mat, Mat_VarCreate("sig", MAT_C_CELL, MAT_T_CELL, 2, two, cells, 0), compression);
    put(mat, array_of_structures(), compression);
    std::vector<float> rows;
    for (std::size_t i = 0; i < mat_rows; ++i) {
        rows.push_back(static_cast<float>(i));
        rows.push_back(-static_cast<float>(i));
    }
    put(mat, Mat_VarCreate("rows", MAT_C_SINGLE, MAT_T_SINGLE, 2, wide, rows.data(), 0), compression);
    std::vector<double> re(mat_rows, 1.0), im(mat_rows, 2.0);
    mat_complex_split_t both{re.data(), im.data()};
    put(mat, Mat_VarCreate("z", MAT_C_DOUBLE, MAT_T_DOUBLE, 2, long_sides, &both, MAT_F_COMPLEX), compression);
    put(mat, Mat_VarCreate("none", MAT_C_DOUBLE, MAT_T_DOUBLE, 2, nothing, nullptr, 0), compression);
    double number = 3.0;
    put(mat, Mat_VarCreate("fs", MAT_C_DOUBLE, MAT_T_DOUBLE, 2, one, &number, 0), compression);
    Mat_Close(mat);
}

std::string refusal(const std::string& file, const std::string& wanted) {
    try {
        read_mat(file, {wanted});
    } catch (const ReadError& error) {
        return error.problem() + " | " + error.allowed();
    }
    return "accepted";
}

class MatContainers : public ::testing::TestWithParam<std::pair<mat_ft, matio_compression>> {
  protected:
    void SetUp() override { write_containers(file(), GetParam().first, GetParam().second); }
    std::string file() const { return folder_.file("a.mat"); }
    ScratchFolder folder_;
};

INSTANTIATE_TEST_SUITE_P(AllVersions, MatContainers,
                         ::testing::Values(std::pair(MAT_FT_MAT5, MAT_COMPRESSION_NONE),
                                           std::pair(MAT_FT_MAT5, MAT_COMPRESSION_ZLIB),
                                           std::pair(MAT_FT_MAT73, MAT_COMPRESSION_NONE)));

TEST_P(MatContainers, ElementsOfCellsAndOfArraysOfStructuresAreChannels) {
    const DataTable table = read_mat(file(), {"sig{2}", "Signal(1).y.values", "Signal(1,2).y.values", "sig{1,1}"});
    ASSERT_EQ(table.rows(), mat_rows);
    EXPECT_EQ(table.columns[0][0], 2.0);
    EXPECT_EQ(table.columns[1][3], 103.0);
    EXPECT_EQ(table.columns[2][0], 200.0);
    EXPECT_EQ(table.columns[3].back(), 1.0 + mat_rows - 1.0);
}

TEST_P(MatContainers, NoElementIsTakenForAnother) {
    EXPECT_EQ(refusal(file(), "Signal.y.values"),
              "'Signal' is an array of structures (1 x 2), and 'Signal.y.values' does not say which of them | "
              "Signal(1).y.values to Signal(2).y.values");
    EXPECT_NE(refusal(file(), "sig:1").find("a cell array (1 x 2) | its elements, sig{1} to sig{2}"),
              std::string::npos);
    EXPECT_NE(refusal(file(), "sig{3}").find("no element 'sig{3}'"), std::string::npos);
    EXPECT_NE(refusal(file(), "Signal(0).y.values").find("variable"), std::string::npos);
    EXPECT_NE(refusal(file(), "Signal(2).x").find("no field of 'Signal(2)' called 'x'"), std::string::npos);
    EXPECT_NE(refusal(file(), "Signal(2)").find("is a structure"), std::string::npos);
}

TEST_P(MatContainers, TheShorterSideCountsChannels) {
    const DataTable table = read_mat(file(), {"rows:2", "rows(1,:)", "sig{1}"});
    ASSERT_EQ(table.rows(), mat_rows);
    EXPECT_EQ(table.columns[0][7], -7.0);
    EXPECT_EQ(table.columns[1][7], 7.0);
    ASSERT_EQ(table.notes.size(), 1U);
    EXPECT_EQ(table.notes[0], "the rows of 'rows' (2 x 40) were taken for its channels");
    EXPECT_NE(refusal(file(), "rows:3").find("no row 3 (2 x 40) | rows:1 to rows:2"), std::string::npos);
    EXPECT_NE(refusal(file(), "rows").find("a matrix of 2 rows"), std::string::npos);
}

TEST_P(MatContainers, WhatIsNoChannelIsCalledWhatItIs) {
    EXPECT_NE(refusal(file(), "z").find("'z' is complex (40 x 1)"), std::string::npos);
    EXPECT_NE(refusal(file(), "none").find("empty"), std::string::npos);
    EXPECT_NE(refusal(file(), "fs").find("a single number"), std::string::npos);
    EXPECT_NE(refusal(file(), "Signal(1).name").find("is text"), std::string::npos);
}

TEST_P(MatContainers, BlocksAddUpToTheWhole) {
    const std::vector<std::string> wanted = {"sig{2}", "rows:1", "rows:2", "Signal(2).y.values"};
    const DataTable whole = read_mat(file(), wanted);
    std::vector<std::vector<double>> joined(wanted.size());
    std::size_t blocks = 0, notes = 0;
    read_mat_blocks(file(), wanted, 7, {}, [&](DataTable& block) {
        ++blocks;
        notes += block.notes.size();
        EXPECT_LE(block.rows(), 7U);
        for (std::size_t i = 0; i < wanted.size(); ++i)
            joined[i].insert(joined[i].end(), block.columns[i].begin(), block.columns[i].end());
    });
    EXPECT_EQ(blocks, 6U);
    EXPECT_EQ(notes, 1U);
    EXPECT_EQ(joined, whole.columns);
}

TEST(Mat, OfVersionFourIsRead) {
    const ScratchFolder folder;
    std::string bytes;
    const auto append = [&](auto value) { bytes.append(reinterpret_cast<const char*>(&value), sizeof value); };
    for (const std::int32_t word : {30, 3, 2, 0, 2}) append(word);  // int16, little endian: 3 x 2, no imaginary part
    bytes += std::string("a\0", 2);
    for (std::int16_t i = 1; i <= 6; ++i) append(i);
    const DataTable table = read_mat(folder.write("a.mat", bytes), {"a:2"});
    EXPECT_EQ(table.columns[0], (std::vector<double>{4, 5, 6}));
    bytes.resize(bytes.size() - 2);
    EXPECT_NE(refusal(folder.write("b.mat", bytes), "a:1").find("cut short: 5 of its 3 x 2"), std::string::npos);
}

TEST(Mat, NumbersThatAreNotThereAreNotRead) {
    // The element ends where the file ends, but its sizes promise more.
    const ScratchFolder folder;
    mat_t* mat = Mat_CreateVer(folder.file("a.mat").c_str(), nullptr, MAT_FT_MAT5);
    put(mat, column("a", 1.0), MAT_COMPRESSION_NONE);
    Mat_Close(mat);
    std::fstream file(folder.file("a.mat"), std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(128 + 8 + 16 + 8);
    const std::int32_t more = 4 * mat_rows;
    file.write(reinterpret_cast<const char*>(&more), sizeof more);
    file.close();
    EXPECT_NE(refusal(folder.file("a.mat"), "a").find("cut short: 40 of its 160 numbers are there"), std::string::npos);
}

/// An attribute with a text that ends with its last letter.
void attach(hid_t object, const char* name, const std::string& text) {
    const hid_t type = H5Tcopy(H5T_C_S1), space = H5Screate(H5S_SCALAR);
    H5Tset_size(type, text.size());
    H5Tset_strpad(type, H5T_STR_NULLPAD);
    const hid_t attribute = H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT);
    H5Awrite(attribute, type, text.data());
    H5Aclose(attribute);
    H5Sclose(space);
    H5Tclose(type);
}

TEST(Mat, OfVersionSevenThreeByOtherProgramsIsRead) {
    const ScratchFolder folder;
    const hid_t root = H5Fcreate(folder.file("a.mat").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
    const hsize_t sizes[] = {2, mat_rows}, single[] = {1, 1};
    std::vector<double> x(2 * mat_rows);
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = static_cast<double>(i);
    const auto dataset = [&](hid_t place, const char* name, const hsize_t* size, const double* values) {
        const hid_t space = H5Screate_simple(2, size, nullptr);
        const hid_t data = H5Dcreate2(place, name, H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
        H5Dwrite(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values);
        attach(data, "MATLAB_class", "double");  // null-padded: no zero at its end
        H5Dclose(data);
        H5Sclose(space);
    };
    const hid_t group = H5Gcreate2(root, "run", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    attach(group, "MATLAB_class", "struct");  // and no MATLAB_fields
    dataset(group, "fs", single, x.data());
    dataset(group, "y", sizes, x.data());
    dataset(root, "acc", sizes, x.data());
    H5Gclose(group);
    H5Fclose(root);
    const DataTable table = read_mat(folder.file("a.mat"), {"run.y:2", "acc:1", "acc(:,2)"});
    ASSERT_EQ(table.rows(), mat_rows);
    EXPECT_EQ(table.columns[0][0], 40.0);
    EXPECT_EQ(table.columns[1][1], 1.0);
    EXPECT_EQ(table.columns[2], table.columns[0]);
}

}  // namespace
}  // namespace railpem::recordings
