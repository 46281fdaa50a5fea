#include "recordings/loading/load_recording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "parameters/parameter_error.hpp"
#include "recordings/files/read_binary.hpp"
#include "recordings/files/read_error.hpp"
#include "recordings/files/uff.hpp"
#include "recordings/loading/hold_against_file.hpp"
#include "recordings/loading/load_tables.hpp"
#include "recordings/recording_parameters.hpp"
#include "recordings/text/read_csv.hpp"
#include "recordings/units.hpp"

namespace railpem::recordings {

namespace fs = std::filesystem;
using parameters::ParameterError;

namespace {

enum class Format { csv, mat, uff, wav, hdf5 };

Format format_of(const fs::path& file) {
    std::string name = file.filename().string();
    std::transform(name.begin(), name.end(), name.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const auto ends = [&](std::string_view end) {
        return name.size() >= end.size() && name.compare(name.size() - end.size(), end.size(), end) == 0;
    };
    if (ends(".csv") || ends(".csv.gz") || ends(".txt") || ends(".tsv") || ends(".txt.gz")) return Format::csv;
    if (ends(".mat")) return Format::mat;
    if (ends(".uff") || ends(".unv")) return Format::uff;
    if (ends(".wav") || ends(".w64") || ends(".rf64")) return Format::wav;
    if (ends(".h5") || ends(".hdf5")) return Format::hdf5;
    throw ParameterError("data", fmt::format("'{}' has an ending that is not known", file.filename().string()),
                         ".csv, .csv.gz, .txt, .tsv, .mat, .uff, .unv, .wav, .w64, .h5");
}

fs::path data_path(const RecordingDescription& description, const fs::path& base) {
    fs::path path = fs::path(description.data).is_absolute() ? fs::path(description.data) : base / description.data;
    std::error_code ignored;
    if (!fs::exists(path, ignored))
        throw ReadError(path.string(), 0, "there is no such file", "a data file beside the description");
    if (!fs::is_regular_file(path, ignored)) throw ReadError(path.string(), 0, "is not a file", "a regular file");
    if (fs::file_size(path, ignored) == 0) throw ReadError(path.string(), 0, "the file is empty", "a file with data");
    return path;
}

const std::string& column_of(const ChannelDescription& channel) {
    return channel.column.empty() ? channel.name : channel.column;
}

/// Columns to read: every channel once, then the time.
std::vector<std::string> wanted_columns(const RecordingDescription& description, const std::string& time_column) {
    std::vector<std::string> wanted;
    const auto add = [&](const std::string& name) {
        if (std::find(wanted.begin(), wanted.end(), name) == wanted.end()) wanted.push_back(name);
    };
    for (const ChannelDescription& channel : description.channels) add(column_of(channel));
    if (!time_column.empty()) add(time_column);
    return wanted;
}

std::string csv_time_column(const RecordingDescription& description, const std::vector<std::string>& names) {
    if (!description.time_column.empty()) return description.time_column;
    for (const char* candidate : {"time_s", "time", "t"})
        if (std::count(names.begin(), names.end(), candidate) == 1) return candidate;
    return "";
}

double rate_from_time(const std::vector<double>& time) {
    // The median step, so that a gap does not spoil it; a millionth of a percent is below what a clock can promise.
    std::vector<double> steps;
    for (std::size_t i = 1; i < time.size(); ++i)
        if (time[i] - time[i - 1] > 0.0) steps.push_back(time[i] - time[i - 1]);
    if (steps.size() < 2) return 0.0;
    std::nth_element(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2), steps.end());
    const double median = steps[steps.size() / 2];
    // Within steps near the median the mean is finer than the digits of a single time.
    double sum = 0.0;
    std::size_t count = 0;
    for (const double step : steps)
        if (std::abs(step - median) < 0.5 * median) {
            sum += step;
            ++count;
        }
    return std::round(1e6 * static_cast<double>(count) / sum) / 1e6;
}

const std::vector<double>& named(const DataTable& table, const std::string& name, const std::string& file) {
    return table.columns[require_name(name, table.names, "column", file, 0)];
}

/// The rate that description, file header and times say, in this order.
void find_sampling_rate(const RecordingDescription& description, const DataTable& table, Recording& recording) {
    TimeSeries& series = recording.series;
    series.sampling_rate_hz = held_sampling_rate(description.sampling_rate_hz, table.sampling_rate_hz,
                                                 table.says.sampling_rate_where, recording.contradictions);
    if (!(series.sampling_rate_hz > 0.0)) series.sampling_rate_hz = rate_from_time(series.time_s);
    if (!(series.sampling_rate_hz > 0.0) || !std::isfinite(series.sampling_rate_hz))
        throw ParameterError("sampling_rate_hz", "neither the description nor the data file says the sampling rate",
                             "a value greater than 0, or a column time_s");
}

/// Puts one column into its channel, in SI units.
void fill_channel(std::size_t i, const DataTable& table, Recording& recording) {
    TimeSeries& series = recording.series;
    ChannelDescription channel = recording.description.channels[i];
    const std::size_t column = require_name(column_of(channel), table.names, "column", recording.file, 0);
    const ColumnStatement says = column < table.says.columns.size() ? table.says.columns[column] : ColumnStatement{};
    const Conversion conversion = conversion_of(channel, says, fmt::format("channel[{}]", i + 1));
    if (conversion.contradiction) recording.contradictions.push_back(*conversion.contradiction);
    if (!conversion.scale_is_known) channel.scale = Scale::unknown;
    std::vector<double> samples = table.columns[column];
    for (double& sample : samples) sample = sample * conversion.factor + conversion.offset;
    if (channel.quantity == ChannelQuantity::speed)
        series.speed_m_per_s = std::move(samples);
    else if (channel.quantity == ChannelQuantity::mileage)
        series.mileage_m = std::move(samples);
    else
        series.channels.push_back({channel, std::move(samples), conversion.says});
}

/// Puts the columns of the table into channels, in SI units.
void fill_series(const RecordingDescription& description, const DataTable& table, const std::string& time_column,
                 Recording& recording) {
    TimeSeries& series = recording.series;
    if (!time_column.empty()) series.time_s = named(table, time_column, recording.file);
    find_sampling_rate(description, table, recording);
    hold_columns_together(table.names, table.says.columns, recording.contradictions);
    hold_promised_rows(table.rows(), table.says.promised_rows, series.sampling_rate_hz, recording.contradictions);
    recording.start = table.says.start;
    for (std::size_t i = 0; i < description.channels.size(); ++i) fill_channel(i, table, recording);
    if (series.channels.empty())
        throw ParameterError("channel", "no channel measures a vibration",
                             "at least one acceleration, velocity or displacement");
    recording.notes.insert(recording.notes.end(), table.notes.begin(), table.notes.end());
}

void read_binary_blocks(const fs::path& path, const std::vector<std::string>& wanted, std::size_t rows,
                        const ReadLimits& limits, const TakeTable& take) {
    switch (format_of(path)) {
        case Format::csv:
            break;
        case Format::mat:
            return read_mat_blocks(path.string(), wanted, rows, limits, take);
        case Format::uff:
            return uff_time_blocks(path.string(), wanted, rows, limits, take);
        case Format::wav:
            return read_wav_blocks(path.string(), wanted, rows, limits, take);
        case Format::hdf5:
            return read_hdf5_blocks(path.string(), wanted, rows, limits, take);
    }
}

DataTable read_table(const fs::path& path, const std::vector<std::string>& wanted, const ReadLimits& limits) {
    if (format_of(path) == Format::csv) return read_csv(path.string(), wanted, limits);
    DataTable all;
    read_binary_blocks(path, wanted, all_rows, limits, [&](DataTable& table) { all = std::move(table); });
    return all;
}

/// What does not depend on the data file.
Recording empty_recording(const RecordingDescription& description, const fs::path& base, const fs::path& path,
                          const ReadLimits& limits) {
    Recording recording;
    recording.description = description;
    recording.file = path.string();
    if (!description.irregularity.empty())
        recording.irregularity = read_irregularity((base / description.irregularity).string(), limits);
    return recording;
}

}  // namespace

std::uintmax_t data_file_bytes(const RecordingDescription& description, const fs::path& base) {
    return fs::file_size(data_path(description, base));
}

Recording load(const RecordingDescription& description, const fs::path& base, const ReadLimits& limits) {
    check(description);
    const fs::path path = data_path(description, base);
    Recording recording = empty_recording(description, base, path, limits);
    switch (description.kind) {
        case RecordingKind::timeseries:
            break;
        case RecordingKind::psd:
            load_psd(recording, limits);
            return recording;
        case RecordingKind::points:
            load_points(recording, limits);
            return recording;
        case RecordingKind::receptance:
            load_receptance(recording, limits);
            return recording;
        case RecordingKind::decay_rate:
            load_decay_rate(recording, limits);
            return recording;
    }
    std::string time_column = description.time_column;
    if (format_of(path) == Format::csv)
        time_column = csv_time_column(description, CsvReader(path.string(), limits).names());
    fill_series(description, read_table(path, wanted_columns(description, time_column), limits), time_column,
                recording);
    return recording;
}

namespace {

/// Rows of a CSV file in blocks of `rows`, with their notes once.
void read_csv_blocks(CsvReader& reader, DataTable table, std::size_t rows, const std::string& file,
                     const TakeTable& take) {
    std::vector<std::size_t> selected;
    for (const std::string& name : table.names)
        selected.push_back(require_name(name, reader.names(), "column", file, reader.header_line()));
    reader.select(selected);
    table.notes = reader.notes();
    for (bool any = false;; any = true) {
        table.columns.assign(table.names.size(), {});
        for (auto& column : table.columns) column.reserve(std::min<std::size_t>(rows, std::size_t{1} << 22));
        if (reader.read(rows, table.columns) == 0) {
            if (any) return;
            throw ReadError(file, reader.header_line(), "there is no row of numbers under the header",
                            "rows of numbers");
        }
        take(table);
        table.notes.clear();
    }
}

}  // namespace

void load_in_sections(const RecordingDescription& description, const fs::path& base, std::size_t samples,
                      const std::function<void(const Recording&)>& work, const ReadLimits& limits) {
    check(description);
    const fs::path path = data_path(description, base);
    if (description.kind != RecordingKind::timeseries) {
        work(load(description, base, limits));
        return;
    }
    std::size_t done = 0;
    std::string time_column = description.time_column;
    Recording bare = empty_recording(description, base, path, limits);
    const auto take = [&](DataTable& table) {
        Recording recording = bare;
        fill_series(bare.description, table, time_column, recording);
        bare.description.sampling_rate_hz = recording.series.sampling_rate_hz;  // one rate for all sections
        recording.series.start_s = static_cast<double>(done) / recording.series.sampling_rate_hz;
        done += recording.series.size();
        table.columns.clear();  // the memory of one section
        work(recording);
    };
    if (format_of(path) != Format::csv) {
        read_binary_blocks(path, wanted_columns(description, time_column), samples, limits, take);
        return;
    }
    CsvReader reader(path.string(), limits);
    time_column = csv_time_column(description, reader.names());
    DataTable table;
    table.names = wanted_columns(description, time_column);
    read_csv_blocks(reader, table, samples, path.string(), take);
}

}  // namespace railpem::recordings
