#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "recordings/files/data_table.hpp"
#include "recordings/files/text_lines.hpp"
#include "recordings/text/csv_layout.hpp"
#include "recordings/text/time_writing.hpp"

namespace railpem::recordings {

/// A CSV file read section by section, so that its size does not matter.
/// A header, perhaps of several rows, under a preamble (csv_layout.hpp); comma, semicolon, tab or blanks between the
/// fields; decimal point or comma, thousands grouped or not; comments (#, %, //) and empty lines; a byte order mark;
/// line ends LF, CR LF or CR; gzip. An empty field and a word for a missing sample are NaN. Ragged rows, text among
/// numbers and a file that stops in the middle of a row are refused with their line.
class CsvReader {
  public:
    /// Opens the file, finds its dialect and its header. `wanted`: names that the header should have, which tell it
    /// from other rows above the table. Throws ReadError.
    explicit CsvReader(std::string file, const ReadLimits& limits = {}, const std::vector<std::string>& wanted = {});

    const ColumnNames& columns() const { return layout_.columns; }
    const std::vector<std::string>& names() const { return layout_.columns.names; }  ///< all, in order, as UTF-8
    const CsvDialect& dialect() const { return layout_.dialect; }
    const std::vector<ColumnStatement>& says() const { return layout_.says; }  ///< per column
    const Preamble& preamble() const { return layout_.preamble; }
    const std::string& file() const { return lines_.file(); }
    std::size_t header_line() const { return layout_.columns.line; }
    std::size_t line() const { return line_; }  ///< of the row read last, from 1

    /// Reads only these columns (indices into names()). Default: all. Columns not selected are counted, not parsed.
    void select(std::vector<std::size_t> columns);

    /// Reads this column as times: numbers as they stand, times of day and dates as seconds since the midnight before
    /// the first. Looks at the first row for how they are written.
    TimeWriting read_times(std::size_t column);
    const std::string& first_time() const { return first_time_; }  ///< as it stands in the file; "" unless a date

    /// Appends up to `rows` rows of the selected columns to `columns` (one vector per selected column); returns how
    /// many. Throws ReadError.
    std::size_t read(std::size_t rows, std::vector<std::vector<double>>& columns);

    /// What was seen and not changed since the last call: at first of the header, then the words for missing samples.
    std::vector<std::string> take_notes();

  private:
    void read_layout(const std::vector<std::string>& wanted);
    bool next_data_line(std::string_view& line);
    void parse_row(std::string_view line, std::vector<std::vector<double>>& columns);
    bool parse_plain_row(std::string_view line, std::vector<std::vector<double>>& columns);
    double parse_cell(std::size_t column, std::string_view field);
    std::optional<double> parse_time(std::string_view field);
    void watch_grouping(std::size_t column, std::string_view field);
    [[noreturn]] void refuse_cell(std::size_t column, std::string_view field) const;
    std::string text_of(std::string_view field) const;

    ReadLimits limits_;
    TextLines lines_;
    CsvLayout layout_;
    std::vector<int> target_;          ///< per column of the file: index of the selected column, or −1
    std::vector<NumberedLine> ahead_;  ///< lines read while finding the layout
    std::size_t ahead_used_ = 0;
    bool ahead_cut_ = false;
    std::size_t line_ = 0;  ///< of the row being parsed
    bool row_was_cut_ = false;
    std::vector<std::string_view> fields_;
    std::size_t time_column_;  ///< beyond all columns: none
    std::optional<long> first_day_;
    std::string first_time_;
    std::map<std::string, std::size_t> missing_;  ///< words for missing samples, and how often
};

/// The whole file. `wanted`: names of the columns; empty: all. Throws ReadError.
DataTable read_csv(const std::string& file, const std::vector<std::string>& wanted = {}, const ReadLimits& limits = {});

/// A CSV whose columns may hold words: every field as text, header first. For small tables. Throws ReadError.
std::vector<std::vector<std::string>> read_csv_text(const std::string& file, const ReadLimits& limits = {});

}  // namespace railpem::recordings
