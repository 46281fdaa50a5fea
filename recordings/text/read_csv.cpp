#include "recordings/text/read_csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "recordings/files/read_error.hpp"
#include "recordings/files/text_encoding.hpp"
#include "recordings/files/visible_text.hpp"
#include "recordings/text/missing_words.hpp"
#include "recordings/text/time_stamp.hpp"

namespace railpem::recordings {
namespace {

/// Enough for a long preamble and for numbers that show how they are written.
constexpr std::size_t lines_for_layout = 512, bytes_for_layout = std::size_t{1} << 18;
constexpr std::size_t no_column = static_cast<std::size_t>(-1);

}  // namespace

CsvReader::CsvReader(std::string file, const ReadLimits& limits, const std::vector<std::string>& wanted)
    : limits_(limits), lines_(std::move(file), limits), time_column_(no_column) {
    read_layout(wanted);
}

void CsvReader::read_layout(const std::vector<std::string>& wanted) {
    std::string_view line;
    std::size_t bytes = 0, rows = 0;
    while (ahead_.size() < lines_for_layout && (bytes < bytes_for_layout || rows < 2) && lines_.next(line)) {
        bytes += line.size();
        rows += is_comment(line) ? 0 : 1;
        ahead_.push_back({std::string(line), lines_.line_number()});
        ahead_cut_ = lines_.last_line_was_cut();
    }
    while (rows == 0 && lines_.next(line)) {  // a preamble of comments longer than that
        if (is_comment(line)) continue;
        rows = 1;
        ahead_.push_back({std::string(line), lines_.line_number()});
        ahead_cut_ = lines_.last_line_was_cut();
    }
    if (rows == 0) throw ReadError(file(), 0, "the file holds comments only", "a header row and rows of numbers");
    layout_ = find_layout(ahead_, wanted);
    ahead_used_ = layout_.first_row;
    if (names().size() > limits_.columns)
        throw ReadError(file(), header_line(), fmt::format("{} columns", names().size()),
                        fmt::format("at most {} columns", limits_.columns));
    std::vector<std::size_t> all(names().size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    select(std::move(all));
}

void CsvReader::select(std::vector<std::size_t> columns) {
    target_.assign(names().size(), -1);
    for (std::size_t i = 0; i < columns.size(); ++i) target_[columns[i]] = static_cast<int>(i);
}

std::string CsvReader::text_of(std::string_view field) const {
    bool converted = false;
    return visible(to_utf8(field, converted).substr(0, 80));
}

bool CsvReader::next_data_line(std::string_view& line) {
    while (ahead_used_ < ahead_.size()) {
        const NumberedLine& next = ahead_[ahead_used_++];
        if (is_comment(next.text)) continue;
        line = next.text;
        line_ = next.number;
        row_was_cut_ = ahead_cut_ && ahead_used_ == ahead_.size();
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

TimeWriting CsvReader::read_times(std::size_t column) {
    time_column_ = column;
    for (std::size_t i = ahead_used_; i < ahead_.size(); ++i) {
        if (is_comment(ahead_[i].text)) continue;
        split_fields(ahead_[i].text, dialect().delimiter, fields_);
        double value = 0.0;
        if (column >= fields_.size() || parse_number(fields_[column], dialect(), value)) return TimeWriting::numbers;
        const std::optional<TimeStamp> stamp = parse_time_stamp(fields_[column]);
        if (!stamp) return TimeWriting::text;
        first_day_ = stamp->day;
        first_time_ = stamp->has_date ? text_of(fields_[column]) : "";
        return stamp->has_date ? TimeWriting::dates : TimeWriting::times_of_day;
    }
    return TimeWriting::numbers;
}

std::optional<double> CsvReader::parse_time(std::string_view field) {
    const std::optional<TimeStamp> stamp = parse_time_stamp(field);
    if (!stamp) return std::nullopt;
    if (!first_day_) first_day_ = stamp->day;
    return 86400.0 * static_cast<double>(stamp->day - *first_day_) + stamp->second;
}

void CsvReader::refuse_cell(std::size_t column, std::string_view field) const {
    const std::string allowed = column == time_column_
                                    ? "seconds, a date and time such as 2024-06-07T13:00:00.002Z, or a time of day"
                                    : fmt::format(
                                          "numbers with a decimal {}, or an empty field, or a word for a missing "
                                          "sample ({})",
                                          dialect().decimal_comma ? "comma" : "point", missing_words);
    throw ReadError(file(), line_,
                    fmt::format("'{}' in column '{}' is not a number", text_of(field), text_of(names()[column])),
                    allowed);
}

void CsvReader::watch_grouping(std::size_t column, std::string_view field) {
    // The first rows were seen when the layout was found.
    GroupingWatch& watch = layout_.watch;
    const bool doubtful = line_ <= ahead_.back().number ? watch.doubtful(column) : watch.observe(column, field);
    if (dialect().grouped || !doubtful) return;
    throw ReadError(
        file(), line_,
        fmt::format("'{}' in column '{}' may be a number of three decimals or thousands: the numbers of this "
                    "column have three digits behind the sign or none at all",
                    watch.example(column), text_of(names()[column])),
        "numbers without a sign between thousands, or with the same decimals in every row");
}

double CsvReader::parse_cell(std::size_t column, std::string_view field) {
    double value = 0.0;
    const FieldKind kind = parse_field(field, dialect(), value);
    if (kind == FieldKind::text) {
        const std::optional<double> time = column == time_column_ ? parse_time(field) : std::nullopt;
        if (!time) refuse_cell(column, field);
        return *time;
    }
    if (kind == FieldKind::number && layout_.watch.watches(column)) watch_grouping(column, field);
    constexpr std::size_t most_words = 20;
    if (kind == FieldKind::missing && !field.empty() && missing_.size() < most_words) ++missing_[text_of(field)];
    return value;
}

std::vector<std::string> CsvReader::take_notes() {
    std::vector<std::string> notes = std::move(layout_.notes);
    layout_.notes.clear();
    for (const auto& [word, count] : missing_)
        notes.push_back(
            fmt::format("'{}' stands in {} field{}: read as missing samples", word, count, count > 1 ? "s" : ""));
    missing_.clear();
    return notes;
}

/// The quick way for rows of plain numbers; false when the row holds anything else, and nothing is appended then.
bool CsvReader::parse_plain_row(std::string_view line, std::vector<std::vector<double>>& columns) {
    const char* at = line.data();
    const char* const end = at + line.size();
    const std::size_t count = names().size();
    for (std::size_t i = 0; i < count; ++i) {
        double value = 0.0;
        const int target = target_[i];
        const auto [stop, error] = std::from_chars(at, end, value);
        const bool complete = error == std::errc() && std::isfinite(value) &&
                              (i + 1 < count ? stop != end && *stop == dialect().delimiter : stop == end);
        if (!complete) {
            for (std::size_t j = 0; j < i; ++j)
                if (target_[j] >= 0) columns[static_cast<std::size_t>(target_[j])].pop_back();
            return false;
        }
        if (target >= 0) {
            columns[static_cast<std::size_t>(target)].push_back(value);
            if (layout_.watch.watches(i)) watch_grouping(i, std::string_view(at, static_cast<std::size_t>(stop - at)));
        }
        at = stop + 1;
    }
    return true;
}

void CsvReader::parse_row(std::string_view line, std::vector<std::vector<double>>& columns) {
    const bool plain =
        !dialect().decimal_comma && !dialect().grouped && dialect().delimiter != ' ' && !dialect().trailing_delimiter;
    if (plain && parse_plain_row(line, columns)) return;
    split_fields(line, dialect().delimiter, fields_);
    if (dialect().trailing_delimiter && fields_.size() == names().size() + 1 && fields_.back().empty())
        fields_.pop_back();
    if (fields_.size() != names().size())
        throw ReadError(file(), line_,
                        row_was_cut_ ? fmt::format("the file stops in the middle of a row ({} of {} fields)",
                                                   fields_.size(), names().size())
                                     : fmt::format("{} fields where the header has {}", fields_.size(), names().size()),
                        fmt::format("{} fields in every row", names().size()));
    for (std::size_t i = 0; i < fields_.size(); ++i)
        if (target_[i] >= 0) columns[static_cast<std::size_t>(target_[i])].push_back(parse_cell(i, fields_[i]));
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
    CsvReader reader(file, limits, wanted);
    DataTable table;
    if (wanted.empty() && !reader.columns().has_header)
        throw ReadError(file, reader.header_line(), "the first row holds numbers: there is no header",
                        "a first row with the names of the columns");
    std::vector<std::size_t> selected = find_columns(wanted, reader.columns(), file);
    if (wanted.empty())
        for (std::size_t i = 0; i < reader.names().size(); ++i) selected.push_back(i);
    table.names = wanted.empty() ? reader.names() : wanted;
    for (const std::size_t index : selected) table.says.columns.push_back(reader.says()[index]);
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
    table.notes = reader.take_notes();
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
