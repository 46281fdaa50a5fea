#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace railpem::recordings {

/// The columns of a text table, and where their names stand.
struct ColumnNames {
    std::vector<std::string> names;  ///< as in the header; "1", "2", … without one
    bool has_header = true;
    std::size_t line = 0;  ///< of the header; without one, of the first row
};

/// Index of the column that `wanted` means: its name; the name without the unit behind it; of several columns of one
/// name "name:2" for the second; the number of the column, from 1, where no column is called so. Throws ReadError with
/// `file` and what would be right.
std::size_t find_column(const std::string& wanted, const ColumnNames& columns, const std::string& file);

/// The same for several.
std::vector<std::size_t> find_columns(const std::vector<std::string>& wanted, const ColumnNames& columns,
                                      const std::string& file);

/// How many of the names the columns have, a number not counted.
std::size_t columns_known(const std::vector<std::string>& wanted, const std::vector<std::string>& names);

}  // namespace railpem::recordings
