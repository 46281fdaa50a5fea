#include "recordings/loading/load_recording.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "parameters/parameter_error.hpp"
#include "recordings/files/read_binary.hpp"
#include "recordings/files/read_error.hpp"
#include "recordings/files/uff.hpp"
#include "recordings/loading/csv_series.hpp"
#include "recordings/loading/file_clock.hpp"
#include "recordings/loading/hold_against_file.hpp"
#include "recordings/loading/load_tables.hpp"
#include "recordings/recording_parameters.hpp"
#include "recordings/units.hpp"

namespace railpem::recordings {

namespace fs = std::filesystem;
using parameters::ParameterError;

namespace {

enum class Format { csv, mat, uff, wav, hdf5 };

struct Ending {
    const char* text;
    Format format;
};

constexpr std::array<Ending, 18> endings = {{{".csv", Format::csv},
                                             {".csv.gz", Format::csv},
                                             {".txt", Format::csv},
                                             {".txt.gz", Format::csv},
                                             {".tsv", Format::csv},
                                             {".tsv.gz", Format::csv},
                                             {".dat", Format::csv},
                                             {".asc", Format::csv},
                                             {".prn", Format::csv},
                                             {".tab", Format::csv},
                                             {".mat", Format::mat},
                                             {".uff", Format::uff},
                                             {".unv", Format::uff},
                                             {".wav", Format::wav},
                                             {".w64", Format::wav},
                                             {".rf64", Format::wav},
                                             {".h5", Format::hdf5},
                                             {".hdf5", Format::hdf5}}};

Format format_of(const fs::path& file) {
    std::string name = file.filename().string();
    std::transform(name.begin(), name.end(), name.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    for (const Ending& ending : endings)
        if (name.ends_with(ending.text)) return ending.format;
    throw ParameterError("data", fmt::format("'{}' has an ending that is not known", file.filename().string()),
                         fmt::format("{}", fmt::join(data_file_endings(), ", ")));
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

/// Columns to read: every channel once, then the time.
std::vector<std::string> wanted_columns(const RecordingDescription& description) {
    std::vector<std::string> wanted = channel_columns(description);
    if (!description.time_column.empty() &&
        std::find(wanted.begin(), wanted.end(), description.time_column) == wanted.end())
        wanted.push_back(description.time_column);
    return wanted;
}

/// What the file says of a column.
ColumnStatement statement_of(std::size_t column, const DataTable& table) {
    return column < table.says.columns.size() ? table.says.columns[column] : ColumnStatement{};
}

/// The clock of a table's times; rates that description and file state help it.
FileClock clock_of(const RecordingDescription& description, const DataTable& table, const std::string& time_column,
                   TimeWriting writing, const std::string& file) {
    if (time_column.empty()) return {{}, writing, 0.0};
    const double rate = description.sampling_rate_hz > 0.0 ? description.sampling_rate_hz : table.sampling_rate_hz;
    return {statement_of(require_name(time_column, table.names, "column", file, 0), table), writing, rate};
}

/// Times in seconds.
void fill_times(const DataTable& table, const std::string& time_column, FileClock& clock, Recording& recording) {
    recording.start = table.says.start;
    if (time_column.empty()) return;
    const std::size_t column = require_name(time_column, table.names, "column", recording.file, 0);
    recording.series.time_s = clock.seconds(table.columns[column], recording.notes, recording.contradictions);
    if (!clock.start().empty()) recording.start = clock.start();
}

/// The rate that description, file header and times say, in this order.
void find_sampling_rate(const RecordingDescription& description, const DataTable& table, Recording& recording) {
    TimeSeries& series = recording.series;
    series.sampling_rate_hz = held_sampling_rate(description.sampling_rate_hz, table.sampling_rate_hz,
                                                 table.says.sampling_rate_where, recording.contradictions);
    bool stand_still = false;
    if (!(series.sampling_rate_hz > 0.0)) series.sampling_rate_hz = rate_of_times(series.time_s, stand_still);
    if (stand_still)
        throw ParameterError(
            "sampling_rate_hz",
            fmt::format("neither the description nor the data file says the sampling rate, and the times do not: "
                        "several rows share each of them ({} rows in {:.4g} s)",
                        series.time_s.size(), series.time_s.back() - series.time_s.front()),
            "a value greater than 0");
    if (!(series.sampling_rate_hz > 0.0) || !std::isfinite(series.sampling_rate_hz))
        throw ParameterError("sampling_rate_hz", "neither the description nor the data file says the sampling rate",
                             "a value greater than 0, or a column time_s");
}

/// Puts one column into its channel, in SI units.
void fill_channel(std::size_t i, const DataTable& table, Recording& recording) {
    TimeSeries& series = recording.series;
    ChannelDescription channel = recording.description.channels[i];
    const std::size_t column = require_name(column_of(channel), table.names, "column", recording.file, 0);
    const Conversion conversion =
        conversion_of(channel, statement_of(column, table), fmt::format("channel[{}]", i + 1));
    if (conversion.contradiction) add_contradiction(*conversion.contradiction, recording.contradictions);
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
                 FileClock& clock, Recording& recording) {
    TimeSeries& series = recording.series;
    fill_times(table, time_column, clock, recording);
    find_sampling_rate(description, table, recording);
    hold_columns_together(table.names, table.says.columns, recording.contradictions);
    hold_promised_rows(table.says.held_rows > 0 ? table.says.held_rows : table.rows(), table.says.promised_rows,
                       series.sampling_rate_hz, recording.contradictions);
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
            break;  // read in sections
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

DataTable read_binary(const fs::path& path, const std::vector<std::string>& wanted, const ReadLimits& limits) {
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

/// A time series in a text file as one section.
void load_csv(const RecordingDescription& description, const fs::path& path, const ReadLimits& limits,
              Recording& recording) {
    CsvSeries source(description, path.string(), limits);
    DataTable table, section;
    constexpr std::size_t rows_at_once = 65536;
    while (source.next(rows_at_once, section)) {
        if (table.names.empty()) {
            table = std::move(section);
            continue;
        }
        for (std::size_t i = 0; i < table.columns.size(); ++i)
            table.columns[i].insert(table.columns[i].end(), section.columns[i].begin(), section.columns[i].end());
        table.notes.insert(table.notes.end(), section.notes.begin(), section.notes.end());
        if (table.rows() * table.columns.size() * sizeof(double) > limits.memory_bytes)
            throw ReadError(path.string(), 0,
                            fmt::format("more than {} MB of numbers to hold at once", limits.memory_bytes >> 20),
                            "reading it in sections");
    }
    if (table.rows() == 0) source.refuse_empty();
    FileClock clock = clock_of(description, table, source.time_column(), source.time_writing(), path.string());
    fill_series(description, table, source.time_column(), clock, recording);
}

}  // namespace

const std::vector<std::string>& data_file_endings() {
    static const std::vector<std::string> all = [] {
        std::vector<std::string> texts;
        for (const Ending& ending : endings) texts.emplace_back(ending.text);
        return texts;
    }();
    return all;
}

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
    if (format_of(path) == Format::csv) {
        load_csv(description, path, limits, recording);
        return recording;
    }
    const DataTable table = read_binary(path, wanted_columns(description), limits);
    FileClock clock = clock_of(description, table, description.time_column, TimeWriting::numbers, path.string());
    fill_series(description, table, description.time_column, clock, recording);
    return recording;
}

namespace {

/// Contradictions of the file as a whole are told once, not again with every section.
void tell_once(std::vector<std::string>& told, std::vector<Fault>& contradictions) {
    std::erase_if(contradictions,
                  [&](const Fault& fault) { return std::find(told.begin(), told.end(), fault.says) != told.end(); });
    for (const Fault& fault : contradictions) told.push_back(fault.says);
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
    std::optional<FileClock> clock;
    std::vector<std::string> told;
    Recording bare = empty_recording(description, base, path, limits);
    const auto take = [&](DataTable& table, const std::string& time_column, TimeWriting writing) {
        if (!clock) clock = clock_of(description, table, time_column, writing, path.string());
        Recording recording = bare;
        fill_series(bare.description, table, time_column, *clock, recording);
        tell_once(told, recording.contradictions);
        bare.description.sampling_rate_hz = recording.series.sampling_rate_hz;  // one rate for all sections
        recording.series.start_s = static_cast<double>(done) / recording.series.sampling_rate_hz;
        done += recording.series.size();
        table.columns.clear();  // the memory of one section
        work(recording);
    };
    if (format_of(path) != Format::csv) {
        read_binary_blocks(path, wanted_columns(description), samples, limits,
                           [&](DataTable& table) { take(table, description.time_column, TimeWriting::numbers); });
        return;
    }
    CsvSeries source(description, path.string(), limits);
    DataTable table;
    while (source.next(samples, table)) take(table, source.time_column(), source.time_writing());
    if (done == 0) source.refuse_empty();
}

}  // namespace railpem::recordings
