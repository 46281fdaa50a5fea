#pragma once
// Universal file format, dataset 58 (function at a nodal degree of freedom), ASCII and binary (58b).
// Structural Dynamics Research Laboratory, University of Cincinnati, "Universal File Datasets Summary", dataset 58.

#include <array>
#include <complex>
#include <functional>
#include <string>
#include <vector>

#include "recordings/files/data_table.hpp"

namespace railpem::recordings {

/// Function types used here (field 1 of record 6).
enum class UffFunction {
    general = 0,
    time_response = 1,
    auto_spectrum = 2,
    cross_spectrum = 3,
    frequency_response = 4,
    power_spectral_density = 9
};

/// The function type in words: "frequency response (function type 4)".
std::string uff_function_name(int function_type);

/// Data types of an axis (field 1 of records 8 to 10).
inline constexpr int uff_time = 17, uff_frequency = 18, uff_displacement = 8, uff_force = 9, uff_velocity = 11,
                     uff_acceleration = 12, uff_excitation_force = 13;

/// One dataset 58.
struct UffDataset {
    std::array<std::string, 5> id;  ///< the five lines of text; the first usually names the function
    std::size_t line = 0;           ///< of the file in which it begins, from 1
    int function_type = 1;
    std::string response_entity, reference_entity;
    int response_node = 0, response_direction = 0;  ///< direction: ±1 x, ±2 y, ±3 z
    int reference_node = 0, reference_direction = 0;
    double abscissa_start = 0.0, abscissa_step = 0.0;  ///< of an even abscissa
    std::vector<double> abscissa;                      ///< of an uneven one; empty: even
    bool complex = false;
    int abscissa_kind = 17;    ///< specific data type of record 8: 17 time, 18 frequency
    int ordinate_kind = 12;    ///< of record 9: 8 displacement, 11 velocity, 12 acceleration, 13 excitation force
    int denominator_kind = 0;  ///< of record 10; 0: none
    std::string abscissa_unit, ordinate_unit, denominator_unit;  ///< as written; empty: none is
    std::vector<double> real;                                    ///< ordinates
    std::vector<double> imaginary;                               ///< of complex ordinates, else empty

    std::size_t size() const { return real.size(); }
    double abscissa_at(std::size_t i) const {
        return abscissa.empty() ? abscissa_start + static_cast<double>(i) * abscissa_step : abscissa[i];
    }
};

/// All datasets 58 and 58b of the file, others skipped. Throws ReadError (truncated, garbage, or no dataset 58).
std::vector<UffDataset> read_uff(const std::string& file, const ReadLimits& limits = {});

/// The names under which a record can be asked for: its number from 1, its first text line, and "node:direction" as in
/// "12:+3".
std::vector<std::string> uff_record_names(const UffDataset& dataset, std::size_t number);

/// The record of that name among the datasets (their place, from 0). Throws ReadError, naming what there is.
std::size_t find_uff_record(const std::vector<UffDataset>& datasets, const std::string& name, const std::string& file);

/// Time responses as a table. An abscissa that is listed in full may be even within its digits. `wanted`: names by
/// uff_record_names(); empty: every real function on an even time axis.
DataTable uff_time_table(const std::string& file, const std::vector<std::string>& wanted,
                         const ReadLimits& limits = {});

/// The same in blocks of `rows`.
void uff_time_blocks(const std::string& file, const std::vector<std::string>& wanted, std::size_t rows,
                     const ReadLimits& limits, const std::function<void(DataTable&)>& take);

/// Writes datasets 58 (ASCII, E20.12, which keeps 13 digits) or 58b (little endian, exact). Throws ReadError when the
/// file cannot be written.
void write_uff(const std::string& file, const std::vector<UffDataset>& datasets, bool binary);

}  // namespace railpem::recordings
