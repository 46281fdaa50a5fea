#pragma once
// Readers built on libraries. Each runs in a child process (isolated_read.hpp); all throw ReadError.

#include <string>
#include <vector>

#include "recordings/files/data_table.hpp"

namespace railpem::recordings {

/// Numeric variables of a MATLAB file (v4, v5, v7, v7.3). A name is a variable, a field of a structure (`run.axlebox`),
/// or a column of a matrix (`data:3`). `wanted` empty: every vector and every column of every matrix, all of one
/// length.
DataTable read_mat(const std::string& file, const std::vector<std::string>& wanted, const ReadLimits& limits = {});

/// Numeric datasets of an HDF5 file. A name is a path in the file (`run/axlebox`) or a column of a two-dimensional
/// dataset
/// (`data:3`, the shorter side counts channels). An attribute `sampling_rate_hz` of the file or of a dataset is taken
/// over.
DataTable read_hdf5(const std::string& file, const std::vector<std::string>& wanted, const ReadLimits& limits = {});

/// Channels of a WAV file (RIFF, RF64, W64), named "1", "2", …. Integer samples come as a share of full scale (−1 … 1),
/// floating-point samples as they are.
DataTable read_wav(const std::string& file, const std::vector<std::string>& wanted, const ReadLimits& limits = {});

}  // namespace railpem::recordings
