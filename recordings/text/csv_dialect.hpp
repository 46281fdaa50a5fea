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
    bool grouped = false;  ///< "1.234" beside "999" is 1234: the sign that is not the decimal one groups thousands

    char decimal() const { return decimal_comma ? ',' : '.'; }
    /// The other of the two signs: where it stands, it groups thousands.
    char grouping() const { return decimal_comma ? '.' : ','; }
};

/// Fields of one line. Quotes around a field are taken off; a doubled quote inside is one.
void split_fields(std::string_view line, char delimiter, std::vector<std::string_view>& fields);

/// Blanks, and one pair of quotes, taken off both ends.
std::string_view trimmed(std::string_view field);

/// A line that carries no data: empty, or a comment that begins with #, % or //. One that begins with a word for a
/// missing sample (#N/A) is none.
bool is_comment(std::string_view line);

/// What a field is in a dialect.
enum class FieldKind { number, grouped_number, missing, text };

/// A number as written in the dialect; an empty field and a word for a missing sample are NaN. Thousands may be grouped
/// by the sign that is not the decimal one, by blanks (also no-break ones) or by apostrophes, if the groups are right.
FieldKind parse_field(std::string_view field, const CsvDialect& dialect, double& value);

/// The same for who does not ask how: false when the field is text.
bool parse_number(std::string_view field, const CsvDialect& dialect, double& value);

/// "1.234" or "-12,345": with this sign a number of three decimals, or one thousand and more.
bool may_be_grouped(std::string_view field, char sign);

/// Delimiter and decimal sign by which the rows of a table are understood best: most rows of numbers and times of one
/// length, under a header of the same length. Tried in turn: tab, semicolon, comma, blank, first with a decimal point,
/// then with a decimal comma. `rows` are the lines that are no comments. `forced`: the delimiter where the file says
/// it, else 0.
CsvDialect detect_dialect(const std::vector<std::string_view>& rows, char forced);

}  // namespace railpem::recordings
