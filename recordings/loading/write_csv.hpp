#pragma once

#include <string>
#include <vector>

#include "recordings/files/data_table.hpp"
#include "recordings/recording.hpp"

namespace railpem::recordings {

/// A header row and rows of numbers with a decimal point; the shortest text that reads back to the same double.
/// NaN becomes an empty field. Throws ReadError when the file cannot be written.
void write_csv(const std::string& file, const DataTable& table);

/// A time series as the table that the description's columns name: time_s, then the channels in SI units.
DataTable to_table(const TimeSeries& series);

}  // namespace railpem::recordings
