#include "app/tables/simulated_recording_files.hpp"

#include <fmt/format.h>
#include <hdf5.h>
#include <matio.h>

#include <algorithm>
#include <fstream>
#include <memory>

#include "app/tables/hdf5_handle.hpp"

namespace railpem::app {

namespace fs = std::filesystem;

namespace {

std::string failure_of(const fs::path& file) {
    return fmt::format("the samples cannot be written to {}\nnothing of this run was kept", file.string());
}

[[noreturn]] void fail(const fs::path& file) {
    throw OutputError(failure_of(file));
}

void write_csv_file(const fs::path& file, const simulate::Recording& recording, const Provenance* provenance) {
    std::ofstream out(file, std::ios::binary);
    simulate::write_csv(out, recording);
    if (provenance) out << stamped(".csv", "", *provenance);
    if (!out.flush()) fail(file);
}

void write_mat_variable(mat_t* mat, const fs::path& file, const std::string& name, const std::vector<double>& values) {
    std::size_t sizes[2] = {values.size(), 1};
    // The library only reads from the data, whatever its interface says.
    const std::unique_ptr<matvar_t, void (*)(matvar_t*)> variable(
        Mat_VarCreate(name.c_str(), MAT_C_DOUBLE, MAT_T_DOUBLE, 2, sizes, const_cast<double*>(values.data()),
                      MAT_F_DONT_COPY_DATA),
        Mat_VarFree);
    if (!variable || Mat_VarWrite(mat, variable.get(), MAT_COMPRESSION_NONE) != 0) fail(file);
}

void write_mat_file(const fs::path& file, const simulate::Recording& recording) {
    // A header of our own: the library's names the time of day, and equal seeds shall give equal bits.
    const std::unique_ptr<mat_t, int (*)(mat_t*)> mat(
        Mat_CreateVer(file.c_str(), "MATLAB 5.0 MAT-file, written by railpem", MAT_FT_MAT5), Mat_Close);
    if (!mat) fail(file);
    write_mat_variable(mat.get(), file, "sampling_rate_hz", {recording.sampling_rate_hz});
    for (const simulate::Channel& channel : recording.channels)
        write_mat_variable(mat.get(), file, channel.name, channel.acceleration_m_per_s2);
    if (!recording.speed_channel_m_per_s.empty())
        write_mat_variable(mat.get(), file, "speed", recording.speed_channel_m_per_s);
}

void write_dataset(hid_t root, const fs::path& file, const std::string& name, const std::vector<double>& values) {
    constexpr hsize_t kChunk = 1u << 16;
    constexpr unsigned kDeflate = 4;
    const hsize_t size = values.size(), chunk = std::min<hsize_t>(kChunk, size);
    const std::string failure = failure_of(file);
    const Hdf5Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose, failure),
        options(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, failure);
    H5Pset_chunk(options.id, 1, &chunk);
    H5Pset_deflate(options.id, kDeflate);
    H5Pset_obj_track_times(options.id, false);  // equal seeds, equal bits
    const Hdf5Handle set(H5Dcreate2(root, name.c_str(), H5T_IEEE_F64LE, space.id, H5P_DEFAULT, options.id, H5P_DEFAULT),
                         H5Dclose, failure);
    if (H5Dwrite(set.id, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0) fail(file);
}

void write_hdf5_file(const fs::path& file, const simulate::Recording& recording) {
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    const std::string failure = failure_of(file);
    const Hdf5Handle root(H5Fcreate(file.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose, failure);
    {
        const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose, failure);
        const Hdf5Handle rate(
            H5Acreate2(root.id, "sampling_rate_hz", H5T_IEEE_F64LE, space.id, H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
            failure);
        if (H5Awrite(rate.id, H5T_NATIVE_DOUBLE, &recording.sampling_rate_hz) < 0) fail(file);
    }
    write_hdf5_stamp(root.id, provenance_line(program_provenance()), failure);
    for (const simulate::Channel& channel : recording.channels)
        write_dataset(root.id, file, channel.name, channel.acceleration_m_per_s2);
    if (!recording.speed_channel_m_per_s.empty())
        write_dataset(root.id, file, "speed", recording.speed_channel_m_per_s);
    if (H5Fflush(root.id, H5F_SCOPE_LOCAL) < 0) fail(file);
}

}  // namespace

std::vector<std::string> recording_files(RecordingFormat format) {
    std::vector<std::string> names{"recording.toml", "recording.csv"};
    if (format == RecordingFormat::mat) names.push_back("recording.mat");
    if (format == RecordingFormat::hdf5) names.push_back("recording.h5");
    return names;
}

void write_simulated_recording(OutputFolder& folder, const simulate::Recording& recording, RecordingFormat format) {
    folder.write_by("recording.csv",
                    [&](const fs::path& file) { write_csv_file(file, recording, folder.provenance()); });
    std::string data = "recording.csv";
    if (format == RecordingFormat::mat) {
        data = "recording.mat";
        folder.write_by(data, [&](const fs::path& file) { write_mat_file(file, recording); });
    } else if (format == RecordingFormat::hdf5) {
        data = "recording.h5";
        folder.write_by(data, [&](const fs::path& file) { write_hdf5_file(file, recording); });
    }
    folder.write("recording.toml", simulate::description(recording, data));
}

}  // namespace railpem::app
