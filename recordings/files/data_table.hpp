#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "recordings/files/file_statements.hpp"

namespace railpem::recordings {

/// Named columns of numbers as they stand in a file, before units. Missing values are NaN.
struct DataTable {
    std::vector<std::string> names;
    std::vector<std::vector<double>> columns;  ///< one per name, all of one length
    double sampling_rate_hz = 0.0;             ///< 0: the file does not say
    std::vector<std::string> notes;            ///< what the reader saw and did not change
    FileStatements says;                       ///< units, scales, … where the file states them

    std::size_t rows() const { return columns.empty() ? 0 : columns.front().size(); }
};

/// What a reader may use up before it refuses the file.
struct ReadLimits {
    std::size_t memory_bytes = std::size_t{4} << 30;  ///< for the numbers held at once
    std::size_t line_bytes = std::size_t{1} << 20;    ///< of one line of text
    std::size_t columns = 4096;
    double seconds = 600.0;  ///< for a library that reads a binary file
};

/// The name nearest to `wanted` by edit distance among `names`, or an empty string when none is near.
std::string nearest_name(const std::string& wanted, const std::vector<std::string>& names);

/// Words for a message: "a, b, c" or "a, b, c … (57 in all)".
std::string listed(const std::vector<std::string>& names);

/// Index of `wanted` in `names`. Throws ReadError with `file`, naming what there is and the nearest name.
std::size_t require_name(const std::string& wanted, const std::vector<std::string>& names, const std::string& what,
                         const std::string& file, std::size_t line);

}  // namespace railpem::recordings
