#pragma once
// A simulated recording as files.

#include <string>
#include <vector>

#include "app/output_folder.hpp"
#include "simulate/recording.hpp"

namespace railpem::app {

enum class RecordingFormat { csv, mat, hdf5 };

/// Names of what write_simulated_recording() writes.
std::vector<std::string> recording_files(RecordingFormat format);

/// recording.toml and recording.csv; with another format also recording.mat (version 5, one variable per channel) or
/// recording.h5 (one data set per channel, `sampling_rate_hz` as an attribute) in full precision, which recording.toml
/// then names. Equal recordings give equal bits in every file. Throws OutputError.
void write_simulated_recording(OutputFolder& folder, const simulate::Recording& recording, RecordingFormat format);

}  // namespace railpem::app
