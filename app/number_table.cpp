#include "app/number_table.hpp"

#include <cassert>
#include <charconv>
#include <cmath>

namespace railpem::app {

namespace {

constexpr std::size_t kLongest = 24;  // sign, digits, point, exponent, separator

}  // namespace

std::string csv_text(const NumberTable& table) {
    assert(table.names.size() == table.columns.size());
    std::string text;
    for (std::size_t i = 0; i < table.names.size(); ++i) text += (i > 0 ? "," : "") + table.names[i];
    text += '\n';
    const std::size_t rows = table.columns.empty() ? 0 : table.columns.front().size();
    std::size_t filled = text.size();
    text.resize(filled + rows * table.columns.size() * kLongest);
    char* end = text.data() + filled;
    for (std::size_t row = 0; row < rows; ++row) {
        for (const std::vector<double>& column : table.columns) {
            if (std::isfinite(column[row]))
                end = std::to_chars(end, end + kLongest - 1, column[row], std::chars_format::general, kDigits).ptr;
            *end++ = ',';
        }
        end[-1] = '\n';
    }
    text.resize(static_cast<std::size_t>(end - text.data()));
    return text;
}

}  // namespace railpem::app
