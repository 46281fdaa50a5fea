#pragma once

#include <functional>
#include <string>

#include "recordings/files/data_table.hpp"

namespace railpem::recordings {

/// Runs `work` in a child process with bounded memory and time, and hands its table back.
///
/// The libraries for MAT, HDF5 and WAV files are large, and a damaged file can stop the process that calls them. In a
/// child that ends as a ReadError here instead of a crash. A ReadError thrown by `work` is thrown again here. `file` is
/// named in the message.
DataTable read_isolated(const std::string& file, const ReadLimits& limits, const std::function<DataTable()>& work);

}  // namespace railpem::recordings
