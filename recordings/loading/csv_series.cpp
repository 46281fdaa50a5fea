#include "recordings/loading/csv_series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "recordings/files/known_units.hpp"
#include "recordings/files/read_error.hpp"
#include "recordings/units.hpp"

namespace railpem::recordings {
namespace {

std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    return text;
}

/// A unit of time at the end of a name: "time_ms", "t_us"; empty: none.
std::string unit_in_name(const std::string& name) {
    const std::size_t at = name.rfind('_');
    if (at == std::string::npos) return "";
    const std::string unit = name.substr(at + 1);
    const std::optional<KnownUnit> known = known_unit(unit);
    return known && known->dimension == Dimension::time ? unit : "";
}

/// Whether a column is called time: in some languages, with its unit behind it or without. A lone letter only with a
/// unit, but for the small t: a T may be a temperature.
bool is_called_time(const std::string& header) {
    const NameWithUnit parts = name_with_unit(header);
    const std::optional<KnownUnit> unit = known_unit(parts.unit);
    if (!parts.unit.empty() && (!unit || unit->dimension != Dimension::time)) return false;
    std::string name = parts.name;
    if (!unit_in_name(name).empty()) name = name.substr(0, name.rfind('_'));
    if (name == "t" || (lower(name) == "t" && !parts.unit.empty())) return true;
    static constexpr std::string_view known[] = {"time",      "timestamp", "time stamp", "time_stamp", "datetime",
                                                 "date_time", "date time", "date/time",  "zeit",       "zeitstempel",
                                                 "temps",     "tiempo",    "tempo",      "tid",        "tijd",
                                                 "czas",      "x_value",   "utc",        "time of day"};
    return std::find(std::begin(known), std::end(known), lower(name)) != std::end(known);
}

}  // namespace

const std::string& column_of(const ChannelDescription& channel) {
    return channel.column.empty() ? channel.name : channel.column;
}

std::vector<std::string> channel_columns(const RecordingDescription& description) {
    std::vector<std::string> columns;
    for (const ChannelDescription& channel : description.channels)
        if (std::find(columns.begin(), columns.end(), column_of(channel)) == columns.end())
            columns.push_back(column_of(channel));
    return columns;
}

CsvSeries::CsvSeries(const RecordingDescription& description, const std::string& file, const ReadLimits& limits)
    : reader_(file, limits, channel_columns(description)), wanted_(channel_columns(description)) {
    std::vector<std::size_t> columns = find_columns(wanted_, reader_.columns(), file);
    find_time_column(description);
    if (!time_column_.empty()) {
        const std::size_t time = find_column(time_column_, reader_.columns(), file);
        const bool also_a_channel = std::find(columns.begin(), columns.end(), time) != columns.end();
        if (!also_a_channel) {
            columns.push_back(time);
            wanted_.push_back(time_column_);
        } else if (std::find(wanted_.begin(), wanted_.end(), time_column_) == wanted_.end()) {
            time_column_.clear();  // a channel under another name; it is read once
        }
    }
    for (const std::size_t column : columns) says_.columns.push_back(reader_.says()[column]);
    if (!time_column_.empty() && says_.columns.back().unit.empty()) {
        says_.columns.back().unit = unit_in_name(time_column_);
        says_.columns.back().unit_where = fmt::format("name of the column, line {}", reader_.header_line());
    }
    take_preamble_unit(description);
    says_.sampling_rate_where = reader_.preamble().sampling_rate_where;
    says_.start = reader_.first_time().empty() ? reader_.preamble().start : reader_.first_time();
    reader_.select(columns);
}

/// A unit above the table is that of every channel that it fits and that has none of its own.
void CsvSeries::take_preamble_unit(const RecordingDescription& description) {
    const Preamble& preamble = reader_.preamble();
    for (const ChannelDescription& channel : description.channels) {
        const auto at = std::find(wanted_.begin(), wanted_.end(), column_of(channel)) - wanted_.begin();
        ColumnStatement& says = says_.columns[static_cast<std::size_t>(at)];
        if (!says.unit.empty() || !factor_of_unit(preamble.unit, channel.quantity)) continue;
        says.unit = preamble.unit;
        says.unit_where = preamble.unit_where;
    }
}

void CsvSeries::find_time_column(const RecordingDescription& description) {
    const std::vector<std::string>& names = reader_.names();
    time_column_ = description.time_column;
    if (time_column_.empty())
        for (const char* candidate : {"time_s", "time", "t"})
            if (time_column_.empty() && std::count(names.begin(), names.end(), candidate) == 1)
                time_column_ = candidate;
    if (time_column_.empty() && std::count_if(names.begin(), names.end(), is_called_time) == 1)
        time_column_ = *std::find_if(names.begin(), names.end(), is_called_time);
    if (time_column_.empty()) return;
    writing_ = reader_.read_times(find_column(time_column_, reader_.columns(), reader_.file()));
    if (writing_ != TimeWriting::text || !description.time_column.empty()) return;
    if (std::find(wanted_.begin(), wanted_.end(), time_column_) != wanted_.end()) return;
    notes_.push_back(fmt::format("column '{}' holds no times that are known and was not used", time_column_));
    time_column_.clear();
}

bool CsvSeries::next(std::size_t rows, DataTable& table) {
    table = {};
    table.names = wanted_;
    table.says = says_;
    table.sampling_rate_hz = reader_.preamble().sampling_rate_hz;
    table.columns.assign(wanted_.size(), {});
    for (auto& column : table.columns) column.reserve(std::min<std::size_t>(rows, std::size_t{1} << 22));
    const std::size_t got = reader_.read(rows, table.columns);
    table.notes = std::move(notes_);
    notes_.clear();
    for (std::string& note : reader_.take_notes()) table.notes.push_back(std::move(note));
    return got > 0;
}

void CsvSeries::refuse_empty() const {
    throw ReadError(reader_.file(), reader_.header_line(), "there is no row of numbers under the header",
                    "rows of numbers");
}

}  // namespace railpem::recordings
