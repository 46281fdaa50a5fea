#pragma once
// The description of a recording: its schema, and recordings read and described with it.

#include <filesystem>
#include <string>

#include "app/schema/document.hpp"
#include "app/schema/read_table.hpp"
#include "app/schema/schema.hpp"
#include "recordings/files/read_error.hpp"
#include "recordings/recording.hpp"

namespace railpem::app {

/// The schema of a recording's description, bound to recordings::RecordingDescription.
const TableSchema& recording_schema();

/// A description with the document that it came from: whoever reads the data can say where something in it is wrong.
struct RecordingFile {
    std::string name;            ///< outputs are called after it: of the folder, or of the file without its extension
    std::filesystem::path base;  ///< what paths in the description are relative to
    recordings::RecordingDescription description;
    Document document;

    bool states(const std::string& key) const { return document.root.find(key) != nullptr; }
};

/// Reads a recording's description, from the file or from `recording.toml` in the folder that `path` names, and checks
/// it; the data are not opened. Throws InputError.
RecordingFile read_recording(const std::string& path, Refuse refuse = Refuse::first);

/// True when a file says by its keys that it describes a recording.
bool is_recording(const Document& document);

/// The message for a data file that cannot be read: "recording.csv:17: …", and the description that it was read for, if
/// there is one.
InputError refused(const recordings::ReadError& error, const std::string& description = "");

/// The message for a recording that is too short, or too full of gaps, for the windows that were asked for.
InputError refused_window(const std::string& description, const parameters::ParameterError& error);

/// Runs `work`, which opens the data of a recording, and turns what it refuses into InputError.
template <class Work>
auto reading_data(const RecordingFile& file, const Work& work) {
    try {
        return work();
    } catch (const recordings::ReadError& error) {
        throw refused(error, file.document.name);
    } catch (const parameters::ParameterError& error) {
        if (error.key() == "window_s") throw refused_window(file.document.name, error);  // no key of a description
        throw refused(file.document, error);
    }
}

/// The data of a recording. Throws InputError.
recordings::Recording load_recording(const RecordingFile& file);

/// The reference page of the recording.
std::string describe_recording();

}  // namespace railpem::app
