#include "recordings/files/read_binary.hpp"

#include "recordings/files/isolated_read.hpp"
#include "recordings/files/read_unprotected.hpp"

namespace railpem::recordings {
namespace {

DataTable whole(ReadBlocks read, const std::string& file, const std::vector<std::string>& wanted,
                const ReadLimits& limits) {
    DataTable all;
    read(file, wanted, all_rows, limits, [&](DataTable& table) { all = std::move(table); });
    return all;
}

}  // namespace

void read_mat_blocks(const std::string& file, const std::vector<std::string>& wanted, std::size_t rows,
                     const ReadLimits& limits, const TakeTable& take) {
    read_isolated_blocks(
        file, limits, [&](const SendTable& send) { read_mat_unprotected(file, wanted, rows, limits, send); }, take);
}

void read_hdf5_blocks(const std::string& file, const std::vector<std::string>& wanted, std::size_t rows,
                      const ReadLimits& limits, const TakeTable& take) {
    read_isolated_blocks(
        file, limits, [&](const SendTable& send) { read_hdf5_unprotected(file, wanted, rows, limits, send); }, take);
}

void read_wav_blocks(const std::string& file, const std::vector<std::string>& wanted, std::size_t rows,
                     const ReadLimits& limits, const TakeTable& take) {
    read_isolated_blocks(
        file, limits, [&](const SendTable& send) { read_wav_unprotected(file, wanted, rows, limits, send); }, take);
}

DataTable read_mat(const std::string& file, const std::vector<std::string>& wanted, const ReadLimits& limits) {
    return whole(read_mat_blocks, file, wanted, limits);
}

DataTable read_hdf5(const std::string& file, const std::vector<std::string>& wanted, const ReadLimits& limits) {
    return whole(read_hdf5_blocks, file, wanted, limits);
}

DataTable read_wav(const std::string& file, const std::vector<std::string>& wanted, const ReadLimits& limits) {
    return whole(read_wav_blocks, file, wanted, limits);
}

}  // namespace railpem::recordings
