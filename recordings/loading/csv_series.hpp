#pragma once

#include <string>

#include "recordings/files/data_table.hpp"
#include "recordings/recording_description.hpp"
#include "recordings/text/read_csv.hpp"

namespace railpem::recordings {

/// A time series in a text file: its channels and its times, read in sections.
class CsvSeries {
  public:
    /// Opens the file and finds the columns. Throws ReadError.
    CsvSeries(const RecordingDescription& description, const std::string& file, const ReadLimits& limits);

    /// The next section, at most `rows` rows, under the names that the description has for the columns. False when
    /// there is no further row. Throws ReadError.
    bool next(std::size_t rows, DataTable& table);

    /// The column of times that the description names, or one whose name says that it is time; empty: none.
    const std::string& time_column() const { return time_column_; }
    TimeWriting time_writing() const { return writing_; }

    /// Refuses a file without a row.
    [[noreturn]] void refuse_empty() const;

  private:
    void find_time_column(const RecordingDescription& description);
    void take_preamble_unit(const RecordingDescription& description);

    CsvReader reader_;
    std::string time_column_;
    TimeWriting writing_ = TimeWriting::numbers;
    std::vector<std::string> wanted_, notes_;
    FileStatements says_;
};

/// The columns of the channels, each once.
std::vector<std::string> channel_columns(const RecordingDescription& description);

/// The column of a channel: as it is stated, else its name.
const std::string& column_of(const ChannelDescription& channel);

}  // namespace railpem::recordings
