#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "recordings/files/data_table.hpp"
#include "recordings/recording.hpp"

namespace railpem::recordings {

/// Reads the data file of a description (relative to `base`) into SI units. Nothing is removed or repaired: missing
/// samples are NaN, the mean stays. A measured irregularity is read with it. What the kind of data cannot tell is
/// listed in Recording::lacks. Throws parameters::ParameterError (the description is wrong) or ReadError (the data file
/// is).
Recording load(const RecordingDescription& description, const std::filesystem::path& base,
               const ReadLimits& limits = {});

/// A time series, section by section, in memory bounded by `samples` per channel however long the file is. Each
/// section is handed to `work` with its start time. A last section shorter than a quarter of the others is joined to
/// none: it is handed over as it is. Other kinds are read as a whole and handed over as one section.
void load_in_sections(const RecordingDescription& description, const std::filesystem::path& base, std::size_t samples,
                      const std::function<void(const Recording&)>& work, const ReadLimits& limits = {});

/// How the names of data files end, in small letters: ".csv", ".csv.gz", ".mat" …
const std::vector<std::string>& data_file_endings();

/// Size of the data file, bytes (as stored). Throws ReadError when there is none.
std::uintmax_t data_file_bytes(const RecordingDescription& description, const std::filesystem::path& base);

}  // namespace railpem::recordings
