#include "recordings/text/csv_dialect.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "recordings/text/missing_words.hpp"
#include "recordings/text/time_stamp.hpp"

namespace railpem::recordings {
namespace {

constexpr std::size_t longest_number = 64;
constexpr std::string_view minus_sign = "\xE2\x88\x92";  // U+2212

bool is_blank(char c) {
    return c == ' ' || c == '\t';
}

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/// What may stand between thousands beside point and comma, longest first: thin and narrow no-break space, no-break
/// space (also the one byte of Latin-1), blank, apostrophe (also the typographic one).
constexpr std::string_view separators[] = {
    "\xE2\x80\xAF", "\xE2\x80\x89", "\xE2\x80\x99", "\xC2\xA0", "\xA0", " ", "'"};

std::string_view separator_at(std::string_view text, char grouping) {
    if (!text.empty() && text.front() == grouping) return text.substr(0, 1);
    for (const std::string_view separator : separators)
        if (text.substr(0, separator.size()) == separator) return separator;
    return {};
}

/// A number with one decimal point and nothing between its thousands, written to `out`; false when the groups are
/// wrong or it is too long. `grouped` says whether there were groups.
bool plain_number(std::string_view field, const CsvDialect& dialect, std::string& out, bool& grouped) {
    out.clear();
    grouped = false;
    if (field.substr(0, minus_sign.size()) == minus_sign) {
        out += '-';
        field.remove_prefix(minus_sign.size());
    } else if (!field.empty() && field.front() == '-') {
        out += '-';
        field.remove_prefix(1);
    }
    std::size_t digits = 0;
    std::string_view used;
    while (!field.empty() && field.front() != dialect.decimal()) {
        if (is_digit(field.front())) {
            out += field.front();
            ++digits;
            field.remove_prefix(1);
            continue;
        }
        const std::string_view separator = separator_at(field, dialect.grouping());
        if (separator.empty()) break;
        // The first group has one to three digits and does not begin with 0, the others have three.
        if (grouped ? digits != 3 || separator != used : digits < 1 || digits > 3 || out[out.size() - digits] == '0')
            return false;
        grouped = true;
        used = separator;
        digits = 0;
        field.remove_prefix(separator.size());
    }
    if (grouped && digits != 3) return false;
    if (field.size() + out.size() > longest_number) return false;
    for (const char c : field)
        if (c == dialect.decimal())
            out += '.';
        else if (c == '.' || c == ',')
            return false;
        else
            out += c == 'D' || c == 'd' ? 'e' : c;  // Fortran's double precision
    return true;
}

bool is_too_small(std::string_view field) {
    return field.find("e-") != std::string_view::npos || field.find("E-") != std::string_view::npos;
}

/// False for anything but a finite number in full; too small for a double is zero, too large is not a measurement.
bool from_text(std::string_view field, double& value) {
    const auto [stop, error] = std::from_chars(field.data(), field.data() + field.size(), value);
    if (stop != field.data() + field.size()) return false;
    if (error == std::errc::result_out_of_range) {
        value = 0.0;
        return is_too_small(field);
    }
    return error == std::errc() && std::isfinite(value);
}

/// How well the rows are understood in a dialect; what comes first decides.
struct Understanding {
    bool under_a_header = false;
    std::size_t begin = 0;  ///< first row of the table
    int rows_of_numbers = 0, rows_of_one_length = 0, numbers = 0, not_grouped = 0;

    auto key() const {
        return std::tuple(rows_of_numbers > 0 && under_a_header, rows_of_numbers, under_a_header && numbers > 0,
                          rows_of_one_length, numbers, not_grouped);
    }
};

/// Of one row: whether all of it is numbers, times or missing, how many are numbers, and of these grouped.
struct RowKind {
    std::size_t fields = 0;
    int numbers = 0, grouped = 0;
    bool all = true;
};

RowKind kind_of_row(std::string_view row, const CsvDialect& dialect, std::vector<std::string_view>& fields) {
    split_fields(row, dialect.delimiter, fields);
    RowKind kind{.fields = fields.size()};
    double value = 0.0;
    for (const std::string_view field : fields) {
        const FieldKind found = parse_field(field, dialect, value);
        if (found == FieldKind::number || found == FieldKind::grouped_number) ++kind.numbers;
        if (found == FieldKind::grouped_number) ++kind.grouped;
        if (found == FieldKind::text) {
            if (parse_time_stamp(field))
                ++kind.numbers;
            else
                kind.all = false;
        }
    }
    return kind;
}

/// The commonest length of the rows of numbers, or of all rows where there are none: a preamble may be longer than what
/// was read of the table. Of several the first row's.
std::size_t table_width(const std::vector<RowKind>& kinds) {
    std::map<std::size_t, int> of_numbers, of_all;
    for (const RowKind& kind : kinds) {
        ++of_all[kind.fields];
        if (kind.all && kind.numbers > 0) ++of_numbers[kind.fields];
    }
    std::map<std::size_t, int>& lengths = of_numbers.empty() ? of_all : of_numbers;
    std::size_t length = kinds.empty() ? 0 : kinds.front().fields;
    for (const auto& [fields, count] : lengths)
        if (count > lengths[length]) length = fields;
    return length;
}

Understanding understanding(const std::vector<RowKind>& kinds) {
    const std::size_t length = table_width(kinds);
    Understanding result;
    bool begun = false;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        if (kinds[i].fields != length) continue;
        // Columns of words may stand beside the numbers: a row begins the table when half of it is numbers.
        if (!begun && kinds[i].numbers > 0 && 2 * kinds[i].numbers >= static_cast<int>(length)) {
            begun = true;
            result.begin = i;
            result.under_a_header = i > 0 && kinds[i - 1].fields == length;
        }
        result.rows_of_numbers += kinds[i].all && kinds[i].numbers > 0 ? 1 : 0;
        result.rows_of_one_length += length > 1 ? 1 : 0;
        result.numbers += kinds[i].numbers;
        result.not_grouped -= kinds[i].grouped;
    }
    return result;
}

/// Without a delimiter a row is one number only where the name above it is one word, too.
bool is_single_column(const std::vector<std::string_view>& rows, const Understanding& found) {
    return found.under_a_header && rows[found.begin - 1].find(',') == std::string_view::npos;
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
    if (line.empty() || line.front() == '%' || line.substr(0, 2) == "//") return true;
    return line.front() == '#' && !is_missing_word(trimmed(line.substr(0, line.find_first_of(",;\t"))));
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

FieldKind parse_field(std::string_view field, const CsvDialect& dialect, double& value) {
    value = std::numeric_limits<double>::quiet_NaN();
    if (field.empty()) return FieldKind::missing;
    std::string_view unsigned_field = field;
    if (field.front() == '+') unsigned_field.remove_prefix(1);
    if (!dialect.decimal_comma && from_text(unsigned_field, value)) return FieldKind::number;
    if (is_missing_word(field)) {
        value = std::numeric_limits<double>::quiet_NaN();
        return FieldKind::missing;
    }
    std::string plain;
    bool grouped = false;
    if (field.size() <= longest_number && plain_number(unsigned_field, dialect, plain, grouped) &&
        from_text(plain, value))
        return grouped ? FieldKind::grouped_number : FieldKind::number;
    return FieldKind::text;
}

bool parse_number(std::string_view field, const CsvDialect& dialect, double& value) {
    return parse_field(field, dialect, value) != FieldKind::text;
}

bool may_be_grouped(std::string_view field, char sign) {
    if (!field.empty() && (field.front() == '-' || field.front() == '+')) field.remove_prefix(1);
    if (field.empty() || field.front() < '1' || field.front() > '9') return false;
    std::size_t digits = 0, groups = 0;
    for (const char c : field) {
        if (is_digit(c)) {
            if (++digits > 3) return false;
        } else if (c == sign) {
            if (groups > 0 && digits != 3) return false;
            ++groups;
            digits = 0;
        } else {
            return false;
        }
    }
    return groups > 0 && digits == 3;
}

CsvDialect detect_dialect(const std::vector<std::string_view>& rows, char forced) {
    const std::string delimiters = forced ? std::string(1, forced) : "\t;, ";
    CsvDialect best{.delimiter = forced ? forced : ','};
    Understanding most;
    bool any = false;
    std::vector<std::string_view> fields;
    for (const char delimiter : delimiters) {
        const bool occurs =
            delimiter == ',' || forced || std::any_of(rows.begin(), rows.end(), [&](std::string_view row) {
                return row.find(delimiter) != std::string_view::npos;
            });
        // The semicolon is tried all the same: it leaves the decimal commas of a single column alone.
        if (!occurs && delimiter != ';') continue;
        for (const bool decimal_comma : {false, true}) {
            const CsvDialect dialect{.delimiter = delimiter, .decimal_comma = decimal_comma};
            std::vector<RowKind> kinds;
            kinds.reserve(rows.size());
            for (const std::string_view row : rows) kinds.push_back(kind_of_row(row, dialect, fields));
            const Understanding found = understanding(kinds);
            if (!occurs && !is_single_column(rows, found)) continue;
            if (any && found.key() <= most.key()) continue;
            any = true;
            most = found;
            best = dialect;
        }
    }
    return best;
}

}  // namespace railpem::recordings
