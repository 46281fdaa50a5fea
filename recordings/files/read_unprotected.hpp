#pragma once
// The readers of read_binary.hpp in the calling process, where a damaged file can end it: what a child process runs,
// and what a fuzzer calls. All throw ReadError.

#include <string>
#include <vector>

#include "recordings/files/data_table.hpp"

namespace railpem::recordings {

DataTable read_mat_unprotected(const std::string& file, const std::vector<std::string>& wanted,
                               const ReadLimits& limits);
DataTable read_hdf5_unprotected(const std::string& file, const std::vector<std::string>& wanted,
                                const ReadLimits& limits);
DataTable read_wav_unprotected(const std::string& file, const std::vector<std::string>& wanted,
                               const ReadLimits& limits);

}  // namespace railpem::recordings
