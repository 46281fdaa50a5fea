#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace railpem::recordings {

/// How a CSV file is written.
struct CsvDialect {
    char delimiter = ',';
    bool decimal_comma = false;
    bool trailing_delimiter = false;  ///< every line ends with one, as some loggers write
};

/// Fields of one line. Quotes around a field are taken off; a doubled quote inside is one.
void split_fields(std::string_view line, char delimiter, std::vector<std::string_view>& fields);

/// Blanks, and one pair of quotes, taken off both ends.
std::string_view trimmed(std::string_view field);

/// A line that carries no data: empty, or a comment that begins with #, % or //.
bool is_comment(std::string_view line);

/// A number as written in the dialect; an empty field, "nan", "na", "n/a", "null" and "-" are NaN.
/// False when the field is something else, an infinity included.
bool parse_number(std::string_view field, bool decimal_comma, double& value);

/// Delimiter and decimal sign by which the header and the first rows have the same number of fields and the rows are
/// numbers. Tried in turn: tab, semicolon, comma, blank. `rows` may be empty: then the header alone decides.
CsvDialect detect_dialect(std::string_view header, const std::vector<std::string>& rows);

}  // namespace railpem::recordings
