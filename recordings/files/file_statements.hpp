#pragma once
// What a data file says about its numbers, beside the numbers. Readers of every format fill it in; the loader uses it
// where the description is silent and holds it against the description where that speaks (hold_against_file.hpp).

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace railpem::recordings {

/// What a data file says about one of its columns. The reader hands the numbers over as they are stored: neither scale
/// nor offset is applied yet. Everything is optional.
struct ColumnStatement {
    std::string unit;                     ///< as written there, of the number once scaled; empty: not said
    std::string unit_where;               ///< where it is said, in words: "row of units, line 2", "attribute 'units'"
    std::optional<double> scale, offset;  ///< number × scale + offset is the value in `unit`; offset is in `unit`
    std::string scale_where;              ///< where scale and offset are said
    bool share_of_full_scale = false;     ///< integers over their full scale, and the file does not say what that is
    std::optional<double> sampling_rate_hz;  ///< of this column, where columns have rates of their own
    std::optional<double> start_s;           ///< time of its first sample on the time axis of the file
};

/// What a data file says about itself as a whole.
struct FileStatements {
    std::vector<ColumnStatement> columns;  ///< empty, or one per column of the table
    std::string sampling_rate_where;       ///< where DataTable::sampling_rate_hz is said; empty: in the header
    std::string start;                     ///< date and time of the first sample, as written there; empty: not said
    std::size_t held_rows = 0;      ///< samples per column in the file; 0: those of the table, which is not a block
    std::size_t promised_rows = 0;  ///< samples per column that its header promises; 0: it promises none
};

}  // namespace railpem::recordings
