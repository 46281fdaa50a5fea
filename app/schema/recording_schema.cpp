#include "app/schema/recording_schema.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/run_inputs.hpp"
#include "app/schema/describe_table.hpp"
#include "recordings/files/visible_text.hpp"
#include "recordings/loading/load_recording.hpp"
#include "recordings/recording_parameters.hpp"

namespace railpem::app {

namespace fs = std::filesystem;
using recordings::ChannelDescription;
using recordings::RecordingDescription;

namespace {

constexpr const char* kDescriptionName = "recording.toml";

Table<RecordingDescription> recording_table() {
    Table<RecordingDescription> table(recordings::recording_fields());
    table.list("channel", &RecordingDescription::channels, "A channel of the data file: what it measures, and where",
               Table<ChannelDescription>(recordings::channel_fields()));
    return table;
}

constexpr const char* kRecordingIntroduction =
    "A recording is a TOML file that says what was measured where, and a data file. Verbs take the TOML file, or the "
    "folder in\n"
    "which it is called `recording.toml`. All channels are positive in the same vertical direction. What the file does "
    "not say\n"
    "(a speed, a sampling rate that the data file holds) may be left out; nothing is guessed.\n\n"
    "| kind | the data file holds |\n"
    "|---|---|\n"
    "| `timeseries` | the samples of every channel: text (.csv, .txt, .tsv, .dat, .asc, .prn, .tab, also .gz), .mat "
    "(v5, v7.3), .uff or .unv (dataset 58, 58b), .wav or .w64, .h5 |\n"
    "| `psd` | CSV: `frequency_hz`, and per channel its PSD in the channel's unit squared per Hz; or universal file: "
    "function type 9 |\n"
    "| `points` | CSV: `channel`, `frequency_hz`, `value`, as a paper quotes them; optional `standard_error` |\n"
    "| `receptance` | CSV: `frequency_hz`, and `re_m_per_n`, `im_m_per_n` or `magnitude_m_per_n`; or "
    "universal file: function type 4 over force, the first or that of a `[[channel]]` |\n"
    "| `decay-rate` | CSV: `centre_hz`, `decay_rate_db_per_m`; optional `standard_error_db_per_m` |\n\n"
    "A text file is a table under a row of names; fields end in a comma, a semicolon, a tab or blanks. What stands "
    "above "
    "the names is\n"
    "a preamble, a row of units may stand below. Numbers have a decimal point or comma, and may have their thousands "
    "grouped. Lines\n"
    "that start with `#`, `%` or `//` are comments. An empty field, or a word such as NaN, #N/A, OVL or ---, is a "
    "missing "
    "sample.\n"
    "A column is addressed by its name, by `name:2` where two have the same name, or by its number. Times are seconds, "
    "another unit\n"
    "that the header names, dates, times of day, or counted since 1970.\n\n"
    "What the data file says of its numbers (units, scale, sampling rate) counts where the description is silent. "
    "Where "
    "both speak\n"
    "and differ, the description is followed and `inspect` says both.\n\n"
    "This page is printed by `railpem describe recording` from the same description that reads the file.";

/// The description that a path means: the file, or the one in the folder.
fs::path description_path(const std::string& path) {
    std::error_code status;
    if (fs::is_directory(path, status)) {
        fs::path inside = fs::path(path) / kDescriptionName;
        if (!fs::exists(inside, status))
            throw InputError(
                fmt::format("{}: the folder holds no {}\nallowed: the folder of a recording, or its description", path,
                            kDescriptionName));
        return inside;
    }
    const std::vector<std::string>& endings = recordings::data_file_endings();
    const bool is_data =
        std::any_of(endings.begin(), endings.end(), [&](const std::string& ending) { return path.ends_with(ending); });
    if (is_data && fs::exists(path, status))
        throw InputError(
            fmt::format("{}: is data without its description\nallowed: a TOML file that names it in `data`; railpem "
                        "describe recording says how",
                        path));
    return path;
}

/// Outputs of a recording that lies in a folder of its own are called after the folder, in characters that can be
/// shown.
std::string recording_name(const fs::path& file) {
    const std::string folder = fs::absolute(file).lexically_normal().parent_path().filename().string();
    return recordings::visible(file.filename() == kDescriptionName && !folder.empty() ? folder : file.stem().string());
}

void check_irregularity(const RecordingFile& file) {
    if (file.description.irregularity.empty()) return;
    std::error_code status;
    const fs::path path = file.base / file.description.irregularity;
    if (!fs::exists(path, status))
        throw file.document.error(file.document.root.find("irregularity")->node.place,
                                  {.what = fmt::format("there is no file '{}'", path.string()),
                                   .allowed = "a path relative to this file",
                                   .hint = ""});
}

}  // namespace

const TableSchema& recording_schema() {
    static const std::shared_ptr<const TableSchema> schema = recording_table().schema();
    return *schema;
}

RecordingFile read_recording(const std::string& path, Refuse refuse) {
    const fs::path file = description_path(path);
    RecordingFile recording{.name = recording_name(file),
                            .base = file.parent_path(),
                            .description = {},
                            .document = read_document(file.string())};
    Refusals found;
    read_table(recording.document, recording_schema(), &recording.description,
               refuse == Refuse::all ? &found : nullptr);
    throw_all(found);
    try {
        recordings::check(recording.description);
    } catch (const parameters::ParameterError& error) {
        throw refused(recording.document, error);
    }
    check_irregularity(recording);
    for (const std::string& read : {recording.description.data, recording.description.irregularity})
        if (!read.empty()) note_input(recording.base / read);
    return recording;
}

bool is_recording(const Document& document) {
    return document.root.find("data") != nullptr || document.root.find("channel") != nullptr;
}

InputError refused_window(const std::string& description, const parameters::ParameterError& error) {
    return InputError(fmt::format("{}: --window: {}\nallowed: {}", description, error.problem(), error.allowed()));
}

InputError refused(const recordings::ReadError& error, const std::string& description) {
    const std::string place = error.line() > 0 ? fmt::format("{}:{}", error.file(), error.line()) : error.file();
    const bool named = !description.empty() && description != error.file();
    return InputError(fmt::format("{}: {}{}{}{}{}", place, error.problem(),
                                  error.allowed().empty() ? "" : "\nallowed: ", error.allowed(),
                                  named ? "\nnamed by: " : "", named ? description : ""));
}

recordings::Recording load_recording(const RecordingFile& file) {
    return reading_data(file, [&] { return recordings::load(file.description, file.base); });
}

std::string describe_recording() {
    const RecordingDescription defaults;
    return describe_table("The recording", kRecordingIntroduction, recording_schema(), &defaults);
}

}  // namespace railpem::app
