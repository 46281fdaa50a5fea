#include "recordings/text/read_csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "recordings/files/read_error.hpp"
#include "recordings/files/text_encoding.hpp"

namespace railpem::recordings {
namespace {

constexpr std::size_t rows_for_dialect = 32;

bool is_number(std::string_view field, const CsvDialect& dialect) {
    double value = 0.0;
    return parse_number(field, dialect.decimal_comma, value) && !std::isnan(value);
}

}  // namespace

CsvReader::CsvReader(std::string file, const ReadLimits& limits) : limits_(limits), lines_(std::move(file), limits) {
    read_header();
}

void CsvReader::read_header() {
    std::string_view line;
    std::string header;
    while (lines_.next(line))
        if (!is_comment(line)) {
            header = std::string(line);
            break;
        }
    header_line_ = lines_.line_number();
    if (header.empty()) throw ReadError(file(), 0, "the file holds comments only", "a header row and rows of numbers");
    while (ahead_.size() < rows_for_dialect && lines_.next(line)) {
        if (is_comment(line)) continue;
        ahead_.emplace_back(line);
        ahead_lines_.push_back(lines_.line_number());
        ahead_cut_ = lines_.last_line_was_cut();
    }
    dialect_ = detect_dialect(header, ahead_);
    split_fields(header, dialect_.delimiter, fields_);
    if (dialect_.trailing_delimiter) fields_.pop_back();
    if (fields_.size() > limits_.columns)
        throw ReadError(file(), header_line_, fmt::format("{} columns", fields_.size()),
                        fmt::format("at most {} columns", limits_.columns));
    bool converted = false;
    for (const std::string_view field : fields_) names_.push_back(to_utf8(field, converted));
    if (converted) notes_.push_back("the header is not UTF-8 and was read as Latin-1");
    if (std::all_of(fields_.begin(), fields_.end(), [&](std::string_view field) { return is_number(field, dialect_); }))
        throw ReadError(file(), header_line_, "the first row holds numbers: there is no header",
                        "a first row with the names of the columns");
    if (!ahead_.empty()) {
        split_fields(ahead_.front(), dialect_.delimiter, fields_);
        if (std::none_of(fields_.begin(), fields_.end(),
                         [&](std::string_view field) { return is_number(field, dialect_); }) &&
            ahead_.size() > 1 && std::any_of(fields_.begin(), fields_.end(), [&](std::string_view field) {
                double v = 0;
                return !parse_number(field, dialect_.decimal_comma, v);
            })) {
            notes_.push_back(fmt::format("line {} was taken as a row of units and not used: {}", ahead_lines_.front(),
                                         text_of(ahead_.front())));
            ahead_used_ = 1;
        }
    }
    std::vector<std::size_t> all(names_.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    select(std::move(all));
}

void CsvReader::select(std::vector<std::size_t> columns) {
    target_.assign(names_.size(), -1);
    for (std::size_t i = 0; i < columns.size(); ++i) target_[columns[i]] = static_cast<int>(i);
}

std::string CsvReader::text_of(std::string_view field) const {
    bool converted = false;
    std::string text = to_utf8(field.substr(0, 80), converted);
    for (char& c : text)
        if (static_cast<unsigned char>(c) < 0x20) c = '?';
    return text;
}

bool CsvReader::next_data_line(std::string_view& line) {
    if (ahead_used_ < ahead_.size()) {
        line = ahead_[ahead_used_];
        line_ = ahead_lines_[ahead_used_];
        row_was_cut_ = ahead_cut_ && ahead_used_ + 1 == ahead_.size();
        ++ahead_used_;
        return true;
    }
    while (lines_.next(line)) {
        const bool begins_like_a_number =
            !line.empty() && (line.front() == '-' || (line.front() >= '0' && line.front() <= '9'));
        if (!begins_like_a_number && is_comment(line)) continue;
        line_ = lines_.line_number();
        row_was_cut_ = lines_.last_line_was_cut();
        return true;
    }
    return false;
}

/// The quick way for rows of plain numbers; false when the row holds anything else, and nothing is appended then.
bool CsvReader::parse_plain_row(std::string_view line, std::vector<std::vector<double>>& columns) {
    const char* at = line.data();
    const char* const end = at + line.size();
    const std::size_t count = names_.size();
    for (std::size_t i = 0; i < count; ++i) {
        double value = 0.0;
        const int target = target_[i];
        const auto [stop, error] = std::from_chars(at, end, value);
        const bool complete = error == std::errc() && std::isfinite(value) &&
                              (i + 1 < count ? stop != end && *stop == dialect_.delimiter : stop == end);
        if (!complete) {
            for (std::size_t j = 0; j < i; ++j)
                if (target_[j] >= 0) columns[static_cast<std::size_t>(target_[j])].pop_back();
            return false;
        }
        if (target >= 0) columns[static_cast<std::size_t>(target)].push_back(value);
        at = stop + 1;
    }
    return true;
}

void CsvReader::parse_row(std::string_view line, std::vector<std::vector<double>>& columns) {
    if (!dialect_.decimal_comma && dialect_.delimiter != ' ' && !dialect_.trailing_delimiter &&
        parse_plain_row(line, columns))
        return;
    split_fields(line, dialect_.delimiter, fields_);
    if (dialect_.trailing_delimiter && fields_.size() == names_.size() + 1 && fields_.back().empty())
        fields_.pop_back();
    if (fields_.size() != names_.size())
        throw ReadError(file(), line_,
                        row_was_cut_ ? fmt::format("the file stops in the middle of a row ({} of {} fields)",
                                                   fields_.size(), names_.size())
                                     : fmt::format("{} fields where the header has {}", fields_.size(), names_.size()),
                        fmt::format("{} fields in every row", names_.size()));
    for (std::size_t i = 0; i < fields_.size(); ++i) {
        double value = 0.0;
        const bool number = parse_number(fields_[i], dialect_.decimal_comma, value);
        if (target_[i] < 0) continue;
        if (!number)
            throw ReadError(file(), line_,
                            fmt::format("'{}' in column '{}' is not a number", text_of(fields_[i]), text_of(names_[i])),
                            dialect_.decimal_comma ? "numbers with a decimal comma, or an empty field"
                                                   : "numbers with a decimal point, or an empty field");
        columns[static_cast<std::size_t>(target_[i])].push_back(value);
    }
}

std::size_t CsvReader::read(std::size_t rows, std::vector<std::vector<double>>& columns) {
    std::string_view line;
    std::size_t done = 0;
    while (done < rows && next_data_line(line)) {
        parse_row(line, columns);
        ++done;
    }
    return done;
}

DataTable read_csv(const std::string& file, const std::vector<std::string>& wanted, const ReadLimits& limits) {
    CsvReader reader(file, limits);
    DataTable table;
    std::vector<std::size_t> selected;
    for (const std::string& name : wanted)
        selected.push_back(require_name(name, reader.names(), "column", file, reader.header_line()));
    if (wanted.empty())
        for (std::size_t i = 0; i < reader.names().size(); ++i) selected.push_back(i);
    for (const std::size_t index : selected) table.names.push_back(reader.names()[index]);
    reader.select(selected);
    table.columns.resize(selected.size());
    constexpr std::size_t rows_at_once = 65536;
    while (reader.read(rows_at_once, table.columns) > 0)
        if (table.rows() * std::max<std::size_t>(1, selected.size()) * sizeof(double) > limits.memory_bytes)
            throw ReadError(file, 0,
                            fmt::format("more than {} MB of numbers to hold at once", limits.memory_bytes >> 20),
                            "reading it in sections");
    if (table.rows() == 0)
        throw ReadError(file, reader.header_line(), "there is no row of numbers under the header", "rows of numbers");
    table.notes = reader.notes();
    return table;
}

std::vector<std::vector<std::string>> read_csv_text(const std::string& file, const ReadLimits& limits) {
    TextLines lines(file, limits);
    std::vector<std::string> kept;
    std::vector<std::size_t> numbers;
    std::string_view line;
    std::size_t bytes = 0;
    while (lines.next(line)) {
        if (is_comment(line)) continue;
        kept.emplace_back(line);
        numbers.push_back(lines.line_number());
        bytes += line.size();
        if (bytes > limits.memory_bytes / 8)
            throw ReadError(file, lines.line_number(), "the table is too large",
                            fmt::format("at most {} MB of text", limits.memory_bytes >> 23));
    }
    if (kept.size() < 2) throw ReadError(file, 0, "there is no row under the header", "a header row and rows");
    char delimiter = ',';
    for (const char candidate : {',', '\t', ';'})
        if (kept.front().find(candidate) != std::string::npos) delimiter = candidate;
    std::vector<std::vector<std::string>> rows;
    std::vector<std::string_view> fields;
    for (std::size_t i = 0; i < kept.size(); ++i) {
        split_fields(kept[i], delimiter, fields);
        if (!rows.empty() && fields.size() != rows.front().size())
            throw ReadError(file, numbers[i],
                            fmt::format("{} fields where the header has {}", fields.size(), rows.front().size()),
                            fmt::format("{} fields in every row", rows.front().size()));
        bool converted = false;
        rows.emplace_back();
        for (const std::string_view field : fields) rows.back().push_back(to_utf8(field, converted));
    }
    return rows;
}

}  // namespace railpem::recordings
