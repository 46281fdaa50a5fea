#pragma once

#include <filesystem>
#include <functional>

#include "app/schema/sweep_schema.hpp"

namespace railpem::app {

inline constexpr std::size_t kCasesPerBlock = 256;  ///< written at a time

/// Values of the rows of cases first … first + count − 1, in order.
using SweepValues = std::function<std::vector<double>(std::size_t first, std::size_t count)>;

/// Bytes that the CSV table would have, estimated from the first case.
double sweep_csv_bytes(const pem::SweepPlan& plan);

/// The long table as CSV: case, the varied keys, (speed_m_per_s with several speeds), quantity, response, frequency_hz
/// (empty for whole spectra), value; at its end `stamp`, a comment line or nothing. Written block by block. Throws
/// OutputError.
void write_sweep_csv(const std::filesystem::path& file, const pem::SweepPlan& plan, const SweepValues& values,
                     const std::string& stamp = "");

/// The same columns as one-dimensional HDF5 data sets of equal length (texts of fixed length, frequency NaN for whole
/// spectra), chunked and deflated; `stamp` is the attribute "provenance" of the file.
void write_sweep_hdf5(const std::filesystem::path& file, const pem::SweepPlan& plan, const SweepValues& values,
                      const std::string& stamp = "");

}  // namespace railpem::app
