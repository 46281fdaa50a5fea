#pragma once

#include <functional>
#include <string>

#include "recordings/files/data_table.hpp"

namespace railpem::recordings {

/// Hands a table on: in the child of read_isolated_blocks(), to the parent.
using SendTable = std::function<void(const DataTable&)>;

/// Runs `work` in a child process with bounded memory and time, and calls `take` with every table that it sends, while
/// the child waits with the next. A table is a block of rows of one file; all have the same columns.
///
/// The libraries for HDF5 and WAV files are large, and a damaged file can stop the process that calls them. In a child
/// that ends as a ReadError here instead of a crash. A ReadError thrown by `work` is thrown again here. `file` is
/// named in the message. The time is that of one table.
void read_isolated_blocks(const std::string& file, const ReadLimits& limits,
                          const std::function<void(const SendTable&)>& work,
                          const std::function<void(DataTable&)>& take);

/// The same with one table, which is handed back.
DataTable read_isolated(const std::string& file, const ReadLimits& limits, const std::function<DataTable()>& work);

}  // namespace railpem::recordings
