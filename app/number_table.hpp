#pragma once

#include <string>
#include <vector>

namespace railpem::app {

inline constexpr int kDigits = 9;  ///< significant ones of a number in any table of the program

/// Named columns of numbers of one length.
struct NumberTable {
    std::vector<std::string> names;
    std::vector<std::vector<double>> columns;
};

/// The table as CSV: a header row, then numbers with a decimal point and nine significant digits, so that the frequency
/// line 0.3 + 7·0.1 reads 1 and no rounding is worse than 5e-9. What is no finite number is an empty field.
std::string csv_text(const NumberTable& table);

}  // namespace railpem::app
