#include <gtest/gtest.h>
#include <hdf5.h>
#include <matio.h>
#include <sndfile.h>

#include <cmath>
#include <numbers>

#include "parameters/parameter_error.hpp"
#include "recordings/files/read_binary.hpp"
#include "recordings/files/read_error.hpp"
#include "recordings/files/uff.hpp"
#include "recordings/loading/load_recording.hpp"
#include "recordings/text/read_csv.hpp"
#include "recordings/units.hpp"
#include "scratch_folder.hpp"

namespace railpem::recordings {
namespace {

using testing::ScratchFolder;

std::vector<double> wave(std::size_t n, double step) {
    std::vector<double> x;
    for (std::size_t i = 0; i < n; ++i) x.push_back(std::sin(step * static_cast<double>(i)) / 3.0);
    return x;
}

void write_mat(const std::string& file, mat_ft version, matio_compression compression) {
    mat_t* mat = Mat_CreateVer(file.c_str(), nullptr, version);
    auto a = wave(50, 0.1);
    std::size_t column[] = {50, 1}, matrix[] = {25, 2};
    matvar_t* v = Mat_VarCreate("axlebox_1", MAT_C_DOUBLE, MAT_T_DOUBLE, 2, column, a.data(), 0);
    Mat_VarWrite(mat, v, compression);
    Mat_VarFree(v);
    std::int16_t counts[50];
    for (int i = 0; i < 50; ++i) counts[i] = static_cast<std::int16_t>(i - 25);
    v = Mat_VarCreate("data", MAT_C_INT16, MAT_T_INT16, 2, matrix, counts, 0);
    Mat_VarWrite(mat, v, compression);
    Mat_VarFree(v);
    const char* fields[] = {"bogie"};
    std::size_t one[] = {1, 1};
    matvar_t* run = Mat_VarCreateStruct("run", 2, one, fields, 1);
    Mat_VarSetStructFieldByName(run, "bogie", 0,
                                Mat_VarCreate(nullptr, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, column, a.data(), 0));
    Mat_VarWrite(mat, run, compression);
    Mat_VarFree(run);
    Mat_Close(mat);
}

TEST(Mat, VectorsColumnsAndFieldsOfAllVersions) {
    const ScratchFolder folder;
    for (const auto& [version, compression] :
         {std::pair(MAT_FT_MAT5, MAT_COMPRESSION_NONE), std::pair(MAT_FT_MAT5, MAT_COMPRESSION_ZLIB),
          std::pair(MAT_FT_MAT73, MAT_COMPRESSION_NONE)}) {
        write_mat(folder.file("a.mat"), version, compression);
        const DataTable table = read_mat(folder.file("a.mat"), {"run.bogie", "axlebox_1"});
        EXPECT_EQ(table.columns[1], wave(50, 0.1));
        EXPECT_EQ(table.columns[0], wave(50, 0.1));
        const DataTable column = read_mat(folder.file("a.mat"), {"data:2"});
        ASSERT_EQ(column.rows(), 25U);
        EXPECT_EQ(column.columns[0][0], 0.0);
        EXPECT_EQ(column.columns[0][24], 24.0);
    }
}

TEST(Mat, Refusals) {
    const ScratchFolder folder;
    write_mat(folder.file("a.mat"), MAT_FT_MAT5, MAT_COMPRESSION_ZLIB);
    for (const char* wanted : {"axlebox_2", "data", "data:3"})
        EXPECT_THROW(read_mat(folder.file("a.mat"), {wanted}), ReadError) << wanted;
    EXPECT_THROW(read_mat(folder.file("a.mat"), {"axlebox_1", "data:1"}), ReadError);  // 50 and 25 samples
    const auto size = std::filesystem::file_size(folder.file("a.mat"));
    for (std::uintmax_t left = size - 1; left > 0; left = left * 2 / 3) {
        std::filesystem::resize_file(folder.file("a.mat"), left);
        EXPECT_THROW(read_mat(folder.file("a.mat"), {"axlebox_1", "run.bogie"}), ReadError) << left;
    }
    write_mat(folder.file("a.mat"), MAT_FT_MAT73, MAT_COMPRESSION_NONE);
    std::filesystem::resize_file(folder.file("a.mat"), std::filesystem::file_size(folder.file("a.mat")) / 2);
    EXPECT_THROW(read_mat(folder.file("a.mat"), {"axlebox_1"}), ReadError);
    EXPECT_THROW(read_mat(folder.write("b.mat", "this is no MATLAB file at all"), {}), ReadError);
}

void write_hdf5(const std::string& file) {
    const hid_t root = H5Fcreate(file.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
    const auto a = wave(60, 0.2);
    const hsize_t vector[] = {60}, matrix[] = {30, 2};
    const hid_t group = H5Gcreate2(root, "run", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    const hid_t space1 = H5Screate_simple(1, vector, nullptr), space2 = H5Screate_simple(2, matrix, nullptr),
                scalar = H5Screate(H5S_SCALAR);
    const hid_t d1 = H5Dcreate2(group, "axlebox", H5T_NATIVE_DOUBLE, space1, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    H5Dwrite(d1, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, a.data());
    const hid_t d2 = H5Dcreate2(root, "data", H5T_IEEE_F64BE, space2, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    H5Dwrite(d2, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, a.data());
    const hid_t rate = H5Acreate2(root, "sampling_rate_hz", H5T_NATIVE_DOUBLE, scalar, H5P_DEFAULT, H5P_DEFAULT);
    const double value = 500.0;
    H5Awrite(rate, H5T_NATIVE_DOUBLE, &value);
    H5Aclose(rate);
    H5Dclose(d1);
    H5Dclose(d2);
    H5Gclose(group);
    for (const hid_t space : {space1, space2, scalar}) H5Sclose(space);
    H5Fclose(root);
}

TEST(Hdf5, DatasetsColumnsAndRate) {
    const ScratchFolder folder;
    write_hdf5(folder.file("a.h5"));
    const DataTable table = read_hdf5(folder.file("a.h5"), {"/run/axlebox"});
    EXPECT_EQ(table.columns[0], wave(60, 0.2));
    EXPECT_EQ(table.sampling_rate_hz, 500.0);
    const DataTable column = read_hdf5(folder.file("a.h5"), {"data:2"});
    ASSERT_EQ(column.rows(), 30U);
    EXPECT_EQ(column.columns[0][3], wave(60, 0.2)[7]);
    EXPECT_THROW(read_hdf5(folder.file("a.h5"), {"data"}), ReadError);
    EXPECT_THROW(read_hdf5(folder.file("a.h5"), {"data:3"}), ReadError);
    EXPECT_THROW(read_hdf5(folder.file("a.h5"), {"run/axelbox"}), ReadError);
    std::filesystem::resize_file(folder.file("a.h5"), std::filesystem::file_size(folder.file("a.h5")) / 2);
    EXPECT_THROW(read_hdf5(folder.file("a.h5"), {"run/axlebox"}), ReadError);
}

TEST(Wav, ChannelsRateAndTruncation) {
    const ScratchFolder folder;
    SF_INFO info{};
    info.samplerate = 2000;
    info.channels = 2;
    info.format = SF_FORMAT_WAV | SF_FORMAT_PCM_16;
    SNDFILE* sound = sf_open(folder.file("a.wav").c_str(), SFM_WRITE, &info);
    std::vector<short> frames;
    for (int i = 0; i < 1000; ++i) {
        frames.push_back(static_cast<short>(i));
        frames.push_back(static_cast<short>(-16384));
    }
    sf_writef_short(sound, frames.data(), 1000);
    sf_close(sound);
    const DataTable table = read_wav(folder.file("a.wav"), {"2", "1"});
    EXPECT_EQ(table.sampling_rate_hz, 2000.0);
    ASSERT_EQ(table.rows(), 1000U);
    EXPECT_EQ(table.columns[0][5], -0.5);
    EXPECT_EQ(table.columns[1][5], 5.0 / 32768.0);
    EXPECT_THROW(read_wav(folder.file("a.wav"), {"3"}), ReadError);
    EXPECT_THROW(read_wav(folder.write("b.wav", "RIFF....WAVE"), {}), ReadError);
}

UffDataset time_response(const std::string& name, int node) {
    UffDataset d;
    d.id[0] = name;
    d.response_node = node;
    d.response_direction = 3;
    d.abscissa_step = 0.0005;
    d.real = wave(37, 0.3);
    d.ordinate_unit = "m/s^2";
    return d;
}

TEST(Uff, WritesAndReadsBackTextAndBinary) {
    const ScratchFolder folder;
    UffDataset complex = time_response("frf", 7);
    complex.function_type = 4;
    complex.complex = true;
    complex.imaginary = wave(37, 0.7);
    complex.denominator_kind = 13;
    complex.abscissa_step = 1.0;
    UffDataset uneven = time_response("uneven", 8);
    for (std::size_t i = 0; i < uneven.size(); ++i) uneven.abscissa.push_back(0.25 * static_cast<double>(i * i));
    for (const bool binary : {false, true}) {
        write_uff(folder.file("a.uff"), {time_response("axlebox_1", 12), complex, uneven}, binary);
        const auto back = read_uff(folder.file("a.uff"));
        ASSERT_EQ(back.size(), 3U);
        EXPECT_EQ(back[0].id[0], "axlebox_1");
        EXPECT_EQ(back[0].response_node, 12);
        EXPECT_EQ(back[0].response_direction, 3);
        EXPECT_EQ(back[0].abscissa_step, 0.0005);
        EXPECT_EQ(back[0].ordinate_unit, "m/s^2");
        EXPECT_TRUE(back[1].complex);
        EXPECT_EQ(back[2].abscissa, uneven.abscissa);
        for (std::size_t i = 0; i < 37; ++i) {
            EXPECT_NEAR(back[0].real[i], wave(37, 0.3)[i], binary ? 0.0 : 1e-13);  // E20.12 keeps 13 digits
            EXPECT_NEAR(back[1].imaginary[i], complex.imaginary[i], binary ? 0.0 : 1e-13);
        }
        const DataTable table = uff_time_table(folder.file("a.uff"), {"axlebox_1"});
        EXPECT_NEAR(table.sampling_rate_hz, 2000.0, 1e-9);
        EXPECT_EQ(uff_time_table(folder.file("a.uff"), {"12:+3"}).rows(), 37U);
        EXPECT_EQ(uff_time_table(folder.file("a.uff"), {"1"}).rows(), 37U);
        EXPECT_THROW(uff_time_table(folder.file("a.uff"), {"frf"}), ReadError);
        EXPECT_THROW(uff_time_table(folder.file("a.uff"), {"axlebox_2"}), ReadError);
        const auto size = std::filesystem::file_size(folder.file("a.uff"));
        for (std::uintmax_t left = size - 8; left > 0; left = left * 3 / 4) {
            std::filesystem::resize_file(folder.file("a.uff"), left);
            try {
                EXPECT_LT(read_uff(folder.file("a.uff")).size(), 3U) << left;  // cut exactly between two datasets, or:
            } catch (const ReadError& error) {
                EXPECT_FALSE(error.problem().empty());
            }
        }
    }
}

TEST(Uff, ReadsSinglePrecisionWithTouchingFieldsAndSkipsOtherDatasets) {
    // Written by hand after the format description: E13.5, six to a line, no blank between negative numbers.
    const std::string content =
        "    -1\n    15\n         1         0         0        11 0.00000E+00 0.00000E+00 0.00000E+00\n    -1\n"
        "    -1\n    58\nFunction\nNONE\nNONE\nNONE\nNONE\n"
        "    1         0    0         0 NONE                1   3 NONE                0   0\n"
        "         2         7         1  0.00000E+00  1.00000E-03  0.00000E+00\n"
        "        17    0    0    0 NONE                 s\n        12    0    0    0 NONE                 m/s^2\n"
        "         0    0    0    0 NONE                 NONE\n         0    0    0    0 NONE                 NONE\n"
        " -1.00000E+00-2.00000E+00-3.00000E+00  4.00000E+00-5.00000E+00  6.00000D+00\n -7.00000E+00\n    -1\n";
    const ScratchFolder folder;
    const auto datasets = read_uff(folder.write("a.unv", content));
    ASSERT_EQ(datasets.size(), 1U);
    EXPECT_EQ(datasets[0].real, (std::vector<double>{-1, -2, -3, 4, -5, 6, -7}));
}

TEST(Units, FactorsAndRefusals) {
    EXPECT_EQ(to_si_factor("g", ChannelQuantity::acceleration, "k"), 9.80665);
    EXPECT_EQ(to_si_factor("mm/s\xC2\xB2", ChannelQuantity::acceleration, "k"), 1e-3);
    EXPECT_EQ(to_si_factor("m/s2", ChannelQuantity::acceleration, "k"), 1.0);
    EXPECT_EQ(to_si_factor("\xC2\xB5m", ChannelQuantity::displacement, "k"), 1e-6);
    EXPECT_EQ(to_si_factor("\xCE\xBCm", ChannelQuantity::displacement, "k"), 1e-6);
    EXPECT_EQ(to_si_factor("mm/s", ChannelQuantity::velocity, "k"), 1e-3);
    EXPECT_DOUBLE_EQ(to_si_factor("km/h", ChannelQuantity::speed, "k"), 1.0 / 3.6);
    EXPECT_EQ(to_si_factor("", ChannelQuantity::displacement, "k"), 1.0);
    try {
        to_si_factor("mm", ChannelQuantity::acceleration, "channel[2].unit");
        FAIL();
    } catch (const parameters::ParameterError& error) {
        EXPECT_EQ(error.key(), "channel[2].unit");
        EXPECT_NE(error.allowed().find("m/s^2"), std::string::npos);
    }
}

RecordingDescription simple_description(const std::string& data) {
    RecordingDescription d;
    d.data = data;
    d.channels = {{.name = "axlebox_1", .column = "a", .unit = "g", .location = Location::wheel, .index = 1},
                  {.name = "speed", .column = "v", .quantity = ChannelQuantity::speed, .unit = "km/h"}};
    return d;
}

TEST(Load, ScalesToSiAndTakesTimeAndSpeed) {
    const ScratchFolder folder;
    folder.write("r.csv", "time_s,a,v\n0,1,72\n0.002,2,72\n0.004,,72\n0.006,4,36\n");
    const Recording recording = load(simple_description("r.csv"), folder.path());
    EXPECT_DOUBLE_EQ(recording.series.sampling_rate_hz, 500.0);
    ASSERT_EQ(recording.series.channels.size(), 1U);
    EXPECT_DOUBLE_EQ(recording.series.channels[0].samples[1], 2.0 * 9.80665);
    EXPECT_TRUE(std::isnan(recording.series.channels[0].samples[2]));
    EXPECT_DOUBLE_EQ(recording.series.speed_m_per_s[0], 20.0);
}

TEST(Load, SectionsAddUpToTheWhole) {
    const ScratchFolder folder;
    std::string content = "time_s,a,v\n";
    for (int i = 0; i < 1050; ++i) content += std::to_string(0.002 * i) + "," + std::to_string(i) + ",72\n";
    folder.write("r.csv", content);
    std::vector<double> joined, starts;
    load_in_sections(simple_description("r.csv"), folder.path(), 500, [&](const Recording& section) {
        starts.push_back(section.series.start_s);
        const auto& x = section.series.channels[0].samples;
        joined.insert(joined.end(), x.begin(), x.end());
    });
    EXPECT_EQ(joined, load(simple_description("r.csv"), folder.path()).series.channels[0].samples);
    ASSERT_EQ(starts.size(), 3U);
    EXPECT_DOUBLE_EQ(starts[1], 1.0);
}

TEST(Load, RefusesDescriptionsThatCannotBe) {
    const ScratchFolder folder;
    folder.write("r.csv", "a,v\n0,1\n1,2\n");
    folder.write("r.doc", "a,v\n0,1\n");
    const auto key_of = [&](const RecordingDescription& d) {
        try {
            load(d, folder.path());
        } catch (const parameters::ParameterError& error) {
            return error.key();
        }
        return std::string("accepted");
    };
    RecordingDescription d = simple_description("r.csv");
    EXPECT_EQ(key_of(d), "sampling_rate_hz");
    d.sampling_rate_hz = 500.0;
    EXPECT_EQ(key_of(d), "accepted");
    RecordingDescription other = d;
    other.data = "r.doc";
    EXPECT_EQ(key_of(other), "data");
    other = d;
    other.channels[0].unit = "kg";
    EXPECT_EQ(key_of(other), "channel[1].unit");
    other = d;
    other.channels[0].index = 0;
    EXPECT_EQ(key_of(other), "channel[1].index");
    other = d;
    other.channels[1].name = "axlebox_1";
    EXPECT_EQ(key_of(other), "channel[2].name");
    other = d;
    other.channels.clear();
    EXPECT_EQ(key_of(other), "channel");
    other = d;
    other.data = "absent.csv";
    EXPECT_THROW(load(other, folder.path()), ReadError);
}

TEST(Load, SpectraPointsReceptanceAndDecayRate) {
    const ScratchFolder folder;
    RecordingDescription d;
    d.kind = RecordingKind::psd;
    d.averages = 25;
    d.data = folder.write("p.csv", "frequency_hz,a\n1,2\n2,4\n");
    d.channels = {{.name = "axlebox_1", .column = "a", .unit = "g", .location = Location::wheel, .index = 1}};
    Recording r = load(d, folder.path());
    EXPECT_DOUBLE_EQ(r.spectra[0].psd[1], 4.0 * 9.80665 * 9.80665);
    EXPECT_DOUBLE_EQ(r.spectra[0].standard_error[1], r.spectra[0].psd[1] / 5.0);
    EXPECT_GE(r.lacks.size(), 2U);

    d.kind = RecordingKind::points;
    d.data = folder.write("q.csv", "channel,frequency_hz,value\na,57.6,4.2\na,66.7,7.0\n");
    d.channels[0].unit = "m/s^2";
    r = load(d, folder.path());
    EXPECT_EQ(r.spectra[0].frequency_hz, (std::vector<double>{57.6, 66.7}));
    EXPECT_EQ(r.spectra[0].psd[0], 4.2);
    d.data = folder.write("q2.csv", "channel,frequency_hz,value\nb,57.6,4.2\n");
    EXPECT_THROW(load(d, folder.path()), ReadError);

    RecordingDescription track;
    track.kind = RecordingKind::receptance;
    track.data = folder.write("r.csv", "frequency_hz,re_m_per_n,im_m_per_n\n10,1e-8,-2e-9\n20,2e-8,-1e-9\n");
    r = load(track, folder.path());
    EXPECT_EQ(r.receptance.value_m_per_n[0], std::complex<double>(1e-8, -2e-9));
    track.data = folder.write("m.csv", "frequency_hz,magnitude_m_per_n\n10,1e-8\n20,2e-8\n");
    r = load(track, folder.path());
    EXPECT_FALSE(r.receptance.has_phase);
    EXPECT_EQ(r.lacks.size(), 3U);
    track.data = folder.write("bad.csv", "frequency_hz,magnitude_m_per_n\n20,1e-8\n10,2e-8\n");
    EXPECT_THROW(load(track, folder.path()), ReadError);

    UffDataset accelerance;
    accelerance.function_type = 4;
    accelerance.complex = true;
    accelerance.ordinate_kind = 12;
    accelerance.denominator_kind = 13;
    accelerance.abscissa_start = 10.0;
    accelerance.abscissa_step = 10.0;
    accelerance.real = {-1.0, -2.0};
    accelerance.imaginary = {0.0, 0.0};
    write_uff(folder.file("frf.uff"), {accelerance}, true);
    track.data = "frf.uff";
    r = load(track, folder.path());
    const double omega = 2.0 * std::numbers::pi * 10.0;
    EXPECT_NEAR(r.receptance.value_m_per_n[0].real(), 1.0 / (omega * omega), 1e-15);

    RecordingDescription decay;
    decay.kind = RecordingKind::decay_rate;
    decay.data = folder.write("d.csv", "centre_hz;decay_rate_db_per_m\n100;11,5\n125;11,2\n");
    r = load(decay, folder.path());
    EXPECT_EQ(r.decay_rate.decay_rate_db_per_m[0], 11.5);
    EXPECT_GE(r.lacks.size(), 2U);
}

TEST(DamagedFiles, EveryReaderRefusesOrReads) {
    // Files that once broke a reader, or might: whatever they hold, a reader returns or throws ReadError.
    const std::filesystem::path folder = std::filesystem::path(RAILPEM_SOURCE_DIR) / "tests/unit/recordings/damaged";
    int files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        ++files;
        const std::string file = entry.path().string();
        const ReadLimits limits{.memory_bytes = std::size_t{64} << 20, .seconds = 20.0};
        for (const auto& reader : {+[](const std::string&f, const ReadLimits&l) { read_csv(f, {}, l); },
                                   +[](const std::string&f, const ReadLimits&l) { read_csv_text(f, l); },
                                   +[](const std::string&f, const ReadLimits&l) { read_uff(f, l); },
                                   +[](const std::string&f, const ReadLimits&l) { read_mat(f, {}, l); },
                                   +[](const std::string&f, const ReadLimits&l) { read_hdf5(f, {}, l); },
                                   +[](const std::string&f, const ReadLimits&l) { read_wav(f, {}, l); }}) {
            try {
                reader(file, limits);
            } catch (const ReadError& error) {
                EXPECT_FALSE(error.allowed().empty()) << error.what();
            }
        }
    }
    EXPECT_GE(files, 20);
}

}  // namespace
}  // namespace railpem::recordings
