#pragma once
// The readers of read_binary.hpp in the calling process, where a damaged file can end it: what a child process runs,
// and what a fuzzer calls. All throw ReadError.

#include <string>
#include <vector>

#include "recordings/files/isolated_read.hpp"

namespace railpem::recordings {

void read_mat_unprotected(const std::string& file, const std::vector<std::string>& wanted, std::size_t rows,
                          const ReadLimits& limits, const SendTable& send);
void read_hdf5_unprotected(const std::string& file, const std::vector<std::string>& wanted, std::size_t rows,
                           const ReadLimits& limits, const SendTable& send);
void read_wav_unprotected(const std::string& file, const std::vector<std::string>& wanted, std::size_t rows,
                          const ReadLimits& limits, const SendTable& send);

}  // namespace railpem::recordings
