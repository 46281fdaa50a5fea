#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "recordings/files/data_table.hpp"
#include "recordings/files/text_lines.hpp"
#include "recordings/text/csv_dialect.hpp"

namespace railpem::recordings {

/// A CSV file read section by section, so that its size does not matter.
/// Header row; comma, semicolon, tab or blanks between the fields; decimal point or comma; comments (#, %, //) and
/// empty lines; a byte order mark; a row of units under the header; gzip. An empty field is a missing sample (NaN).
/// Ragged rows, text among numbers and a file that stops in the middle of a row are refused with their line.
class CsvReader {
  public:
    /// Opens the file, finds its dialect and its header. Throws ReadError.
    explicit CsvReader(std::string file, const ReadLimits& limits = {});

    const std::vector<std::string>& names() const { return names_; }  ///< all columns, in order, as UTF-8
    const CsvDialect& dialect() const { return dialect_; }
    const std::vector<std::string>& notes() const { return notes_; }
    const std::string& file() const { return lines_.file(); }
    std::size_t header_line() const { return header_line_; }
    std::size_t line() const { return line_; }  ///< of the row read last, from 1

    /// Reads only these columns (indices into names()). Default: all. Columns not selected are counted, not parsed.
    void select(std::vector<std::size_t> columns);

    /// Appends up to `rows` rows of the selected columns to `columns` (one vector per selected column); returns how
    /// many. Throws ReadError.
    std::size_t read(std::size_t rows, std::vector<std::vector<double>>& columns);

  private:
    void read_header();
    bool next_data_line(std::string_view& line);
    void parse_row(std::string_view line, std::vector<std::vector<double>>& columns);
    bool parse_plain_row(std::string_view line, std::vector<std::vector<double>>& columns);
    std::string text_of(std::string_view field) const;

    ReadLimits limits_;
    TextLines lines_;
    std::vector<std::string> names_;
    CsvDialect dialect_;
    std::vector<std::string> notes_;
    std::vector<int> target_;         ///< per column of the file: index of the selected column, or −1
    std::vector<std::string> ahead_;  ///< rows read while finding the dialect
    std::size_t ahead_used_ = 0;
    std::vector<std::size_t> ahead_lines_;
    bool ahead_cut_ = false;
    std::size_t header_line_ = 0;
    std::size_t line_ = 0;  ///< of the row being parsed
    bool row_was_cut_ = false;
    std::vector<std::string_view> fields_;
};

/// The whole file. `wanted`: names of the columns; empty: all. Throws ReadError.
DataTable read_csv(const std::string& file, const std::vector<std::string>& wanted = {}, const ReadLimits& limits = {});

/// A CSV whose columns may hold words: every field as text, header first. For small tables. Throws ReadError.
std::vector<std::vector<std::string>> read_csv_text(const std::string& file, const ReadLimits& limits = {});

}  // namespace railpem::recordings
