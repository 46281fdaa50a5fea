#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace railpem::recordings {

/// A line of a text file, and which.
struct NumberedLine {
    std::string text;
    std::size_t number = 0;  ///< from 1
};

/// What the lines above a table say of it in so many words: "Sample rate: 500 Hz", "# fs = 1000", "Delta_X;0.002",
/// "Unit: g", "Date: 2024-06-07 13:00:00".
struct Preamble {
    double sampling_rate_hz = 0.0;  ///< 0: not said
    std::string sampling_rate_where;
    std::string unit, unit_where;  ///< of the channels that say none themselves; empty: not said
    std::string start;             ///< date and time; empty: not said
};

/// Reads the lines that are known. Comment signs and quotes are taken off, everything else is left alone.
Preamble read_preamble(const std::vector<NumberedLine>& lines);

}  // namespace railpem::recordings
