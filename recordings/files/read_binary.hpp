#pragma once
// Readers of binary files. Each runs in a child process (isolated_read.hpp); all throw ReadError. `wanted` empty: every
// channel, all of one length.

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "recordings/files/data_table.hpp"

namespace railpem::recordings {

/// The whole file as one block.
inline constexpr std::size_t all_rows = static_cast<std::size_t>(-1);

/// Takes the next rows of a file: all columns, and the notes with the first of them.
using TakeTable = std::function<void(DataTable&)>;

/// Reads a file in blocks of `rows`, in memory that does not grow with the file.
using ReadBlocks = void (*)(const std::string& file, const std::vector<std::string>& wanted, std::size_t rows,
                            const ReadLimits& limits, const TakeTable& take);

/// Numeric variables of a MATLAB file (v4, v5, v7, v7.3). A name is a variable, a field of a structure (`run.axlebox`),
/// an element of an array of structures or of cells (`ch(2).y`, `sig{2}`), or a channel of a matrix (`data:3`, the
/// shorter side counts channels; `data(:,3)` a column, `data(3,:)` a row).
void read_mat_blocks(const std::string& file, const std::vector<std::string>& wanted, std::size_t rows,
                     const ReadLimits& limits, const TakeTable& take);

/// Numeric datasets of an HDF5 file. A name is a path in the file (`run/axlebox`) or a column of a two-dimensional
/// dataset (`data:3`, the shorter side counts channels). An attribute `sampling_rate_hz` of the file or of a dataset is
/// taken over.
void read_hdf5_blocks(const std::string& file, const std::vector<std::string>& wanted, std::size_t rows,
                      const ReadLimits& limits, const TakeTable& take);

/// Channels of a WAV file (RIFF, RF64, W64), named "1", "2", …. Integer samples come as a share of full scale (−1 … 1),
/// floating-point samples as they are.
void read_wav_blocks(const std::string& file, const std::vector<std::string>& wanted, std::size_t rows,
                     const ReadLimits& limits, const TakeTable& take);

DataTable read_mat(const std::string& file, const std::vector<std::string>& wanted, const ReadLimits& limits = {});
DataTable read_hdf5(const std::string& file, const std::vector<std::string>& wanted, const ReadLimits& limits = {});
DataTable read_wav(const std::string& file, const std::vector<std::string>& wanted, const ReadLimits& limits = {});

}  // namespace railpem::recordings
