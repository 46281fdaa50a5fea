#include "recordings/text/csv_dialect.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

namespace railpem::recordings {
namespace {

bool is_blank(char c) {
    return c == ' ' || c == '\t';
}

bool equal_ignoring_case(std::string_view text, std::string_view lower) {
    return std::equal(text.begin(), text.end(), lower.begin(), lower.end(),
                      [](char a, char b) { return (a >= 'A' && a <= 'Z' ? static_cast<char>(a + 32) : a) == b; });
}

bool is_missing(std::string_view field) {
    for (const char* word : {"nan", "na", "n/a", "null", "-"})
        if (equal_ignoring_case(field, word)) return true;
    return false;
}

/// How many of the first rows are rows of numbers with as many fields as the header has.
int rows_understood(std::string_view header, const std::vector<std::string>& rows, const CsvDialect& dialect) {
    std::vector<std::string_view> fields;
    split_fields(header, dialect.delimiter, fields);
    const std::size_t wanted = fields.size();
    int understood = 0;
    for (const std::string& row : rows) {
        split_fields(row, dialect.delimiter, fields);
        double value = 0.0;
        const bool numbers = std::all_of(fields.begin(), fields.end(), [&](std::string_view field) {
            return parse_number(field, dialect.decimal_comma, value);
        });
        understood += numbers && fields.size() == wanted ? 1 : 0;
    }
    return understood;
}

}  // namespace

std::string_view trimmed(std::string_view field) {
    while (!field.empty() && is_blank(field.front())) field.remove_prefix(1);
    while (!field.empty() && is_blank(field.back())) field.remove_suffix(1);
    if (field.size() >= 2 && field.front() == '"' && field.back() == '"') field = field.substr(1, field.size() - 2);
    return field;
}

bool is_comment(std::string_view line) {
    while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
    return line.empty() || line.front() == '#' || line.front() == '%' || line.substr(0, 2) == "//";
}

void split_fields(std::string_view line, char delimiter, std::vector<std::string_view>& fields) {
    fields.clear();
    if (delimiter == ' ') {  // any number of blanks is one delimiter
        for (std::size_t at = 0; at < line.size();) {
            while (at < line.size() && is_blank(line[at])) ++at;
            const std::size_t begin = at;
            while (at < line.size() && !is_blank(line[at])) ++at;
            if (at > begin) fields.push_back(line.substr(begin, at - begin));
        }
        return;
    }
    std::size_t begin = 0;
    bool quoted = false;
    for (std::size_t at = 0; at < line.size(); ++at) {
        if (line[at] == '"') quoted = !quoted;
        if (line[at] != delimiter || quoted) continue;
        fields.push_back(trimmed(line.substr(begin, at - begin)));
        begin = at + 1;
    }
    fields.push_back(trimmed(line.substr(begin)));
}

bool parse_number(std::string_view field, bool decimal_comma, double& value) {
    if (field.empty() || is_missing(field)) {
        value = std::numeric_limits<double>::quiet_NaN();
        return true;
    }
    if (field.front() == '+') field.remove_prefix(1);
    std::array<char, 64> copy;
    if (decimal_comma) {
        if (field.size() > copy.size() || field.find('.') != std::string_view::npos) return false;
        std::replace_copy(field.begin(), field.end(), copy.begin(), ',', '.');
        field = std::string_view(copy.data(), field.size());
    }
    const auto [stop, error] = std::from_chars(field.data(), field.data() + field.size(), value);
    if (stop != field.data() + field.size()) return false;
    if (error == std::errc::result_out_of_range) {
        // Too small for a double is zero; too large is not a measurement.
        value = 0.0;
        return field.find("e-") != std::string_view::npos || field.find("E-") != std::string_view::npos;
    }
    return error == std::errc() && std::isfinite(value);
}

CsvDialect detect_dialect(std::string_view header, const std::vector<std::string>& rows) {
    CsvDialect best;
    int best_score = -1;
    for (const char delimiter : {'\t', ';', ',', ' '}) {
        if (header.find(delimiter) == std::string_view::npos && delimiter != ',') continue;
        for (const bool decimal_comma : {false, true}) {
            if (decimal_comma && delimiter == ',' && header.find(',') != std::string_view::npos) continue;
            const CsvDialect dialect{.delimiter = delimiter, .decimal_comma = decimal_comma};
            const int score = rows_understood(header, rows, dialect);
            if (score > best_score) {
                best_score = score;
                best = dialect;
            }
        }
    }
    // A single column with decimal commas: there is nothing to separate, and the comma is not a delimiter.
    if (best.decimal_comma && best.delimiter == ',') best.delimiter = ';';
    std::vector<std::string_view> fields;
    split_fields(header, best.delimiter, fields);
    best.trailing_delimiter = best.delimiter != ' ' && fields.size() > 1 && fields.back().empty();
    return best;
}

}  // namespace railpem::recordings
