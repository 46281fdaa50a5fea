#include "recordings/text/csv_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "recordings/files/known_units.hpp"
#include "recordings/files/text_encoding.hpp"
#include "recordings/files/visible_text.hpp"
#include "recordings/text/time_stamp.hpp"

namespace railpem::recordings {
namespace {

using Fields = std::vector<std::string_view>;

/// A line that is no comment.
struct Row {
    std::size_t line = 0;  ///< index into the lines
    Fields fields;
};

enum class Cell { number, missing, text };

Cell cell_of(std::string_view field, const CsvDialect& dialect) {
    double value = 0.0;
    const FieldKind kind = parse_field(field, dialect, value);
    if (kind == FieldKind::missing) return Cell::missing;
    return kind != FieldKind::text || parse_time_stamp(field) ? Cell::number : Cell::text;
}

/// "sep=;" as Excel needs it on the first line: the delimiter, else 0.
char stated_delimiter(std::string_view line) {
    line = trimmed(line);
    const auto is = [&](std::size_t i, char lower) { return (line[i] | 0x20) == lower; };
    return line.size() == 5 && is(0, 's') && is(1, 'e') && is(2, 'p') && line[3] == '=' ? line[4] : '\0';
}

/// The commonest number of fields of rows that are numbers by half or more, else of all rows; of several the first
/// row's.
std::size_t width_of(const std::vector<Row>& rows, const CsvDialect& dialect) {
    std::map<std::size_t, int> of_all, of_numbers;
    for (const Row& row : rows) {
        ++of_all[row.fields.size()];
        const auto numbers = std::count_if(row.fields.begin(), row.fields.end(), [&](std::string_view field) {
            return cell_of(field, dialect) == Cell::number;
        });
        const bool is_first = !row.fields.empty() && cell_of(row.fields.front(), dialect) != Cell::text;
        if (is_first && 2 * numbers >= static_cast<std::ptrdiff_t>(row.fields.size())) ++of_numbers[row.fields.size()];
    }
    std::map<std::size_t, int>& widths = of_numbers.empty() ? of_all : of_numbers;
    std::size_t width = rows.front().fields.size();
    for (const auto& [fields, count] : widths)
        if (count > widths[width]) width = fields;
    return width;
}

/// Which columns hold numbers or times, by the second half of the rows.
std::vector<bool> number_columns(const std::vector<Row>& rows, std::size_t width, const CsvDialect& dialect) {
    std::vector<int> balance(width, 0);
    std::vector<bool> numbers(width, false);
    for (std::size_t i = rows.size() / 2; i < rows.size(); ++i) {
        if (rows[i].fields.size() != width) continue;
        for (std::size_t j = 0; j < width; ++j) {
            const Cell cell = cell_of(rows[i].fields[j], dialect);
            balance[j] += cell == Cell::number ? 1 : cell == Cell::text ? -1 : 0;
            if (cell == Cell::number) numbers[j] = true;
        }
    }
    for (std::size_t j = 0; j < width; ++j) numbers[j] = numbers[j] && balance[j] >= 0;
    return numbers;
}

/// A row of the table has no words in the first of these columns, and in at most half of them.
bool is_table_row(const Row& row, const std::vector<bool>& numbers, const CsvDialect& dialect) {
    if (row.fields.size() != numbers.size()) return false;
    std::size_t wanted = 0, held = 0;
    bool anything = false;
    for (std::size_t j = 0; j < numbers.size(); ++j) {
        if (!numbers[j]) continue;
        const Cell cell = cell_of(row.fields[j], dialect);
        if (wanted++ == 0 && cell == Cell::text) return false;
        held += cell != Cell::text ? 1 : 0;
        anything = anything || !row.fields[j].empty();
    }
    return wanted > 0 && anything && 2 * held >= wanted;
}

bool says_no_unit(std::string_view field) {
    static constexpr std::string_view nothing[] = {"-",    "--",    "1",       "[-]",      "(-)",  "none",
                                                   "None", "NONE",  "n/a",     "[1]",      "Unit", "Units",
                                                   "unit", "units", "Einheit", "Einheiten"};
    return std::find(std::begin(nothing), std::end(nothing), field) != std::end(nothing);
}

bool is_units_row(const Row& row) {
    std::size_t words = 0, units = 0;
    for (const std::string_view field : row.fields) {
        if (field.empty() || says_no_unit(field)) continue;
        ++words;
        units += known_unit(field) ? 1 : 0;
    }
    return units > 0 && 2 * units >= words;
}

/// How well a row serves as the names of the columns.
std::pair<std::size_t, std::size_t> names_score(const Row& row, const std::vector<std::string>& wanted,
                                                const CsvDialect& dialect, bool only_row) {
    std::vector<std::string> names;
    std::set<std::string_view> different;
    bool converted = false;
    for (const std::string_view field : row.fields) {
        names.push_back(to_utf8(field, converted));
        if (!field.empty() && cell_of(field, dialect) != Cell::number) different.insert(field);
    }
    return {columns_known(wanted, names), only_row || !is_units_row(row) ? different.size() : 0};
}

/// Builds the layout from the rows; what every step needs is kept beside it.
struct Builder {
    const std::vector<NumberedLine>& lines;
    const std::vector<std::string>& wanted;
    CsvLayout layout;
    std::vector<Row> rows;
    std::size_t width = 0;
    std::size_t table = 0;     ///< index into rows: first row of the table
    std::size_t preamble = 0;  ///< index into lines: first line that is no preamble

    std::size_t number_of(const Row& row) const { return lines[row.line].number; }

    static std::string shown(std::string_view text) {
        bool converted = false;
        return visible(to_utf8(text, converted).substr(0, 80));
    }

    void split_rows(std::size_t from, char forced) {
        std::vector<std::string_view> texts;
        for (std::size_t i = from; i < lines.size(); ++i)
            if (!is_comment(lines[i].text)) {
                rows.push_back({i, {}});
                texts.emplace_back(lines[i].text);
            }
        if (rows.empty()) return;
        layout.dialect = detect_dialect(texts, forced);
        for (Row& row : rows) split_fields(lines[row.line].text, layout.dialect.delimiter, row.fields);
        width = width_of(rows, layout.dialect);
    }

    /// False when nothing looks like a table: then the first row is the header, and the next is to say what is wrong.
    bool find_table() {
        const std::vector<bool> numbers = number_columns(rows, width, layout.dialect);
        const auto first = std::find_if(rows.begin(), rows.end(),
                                        [&](const Row& row) { return is_table_row(row, numbers, layout.dialect); });
        table = static_cast<std::size_t>(first - rows.begin());
        return first != rows.end();
    }

    void take_names(const Fields& fields, std::size_t line_number, bool has_header) {
        bool converted = false;
        layout.columns = {.names = {}, .has_header = has_header, .line = line_number};
        for (const std::string_view field : fields) layout.columns.names.push_back(to_utf8(field, converted));
        if (converted) layout.notes.emplace_back("the header is not UTF-8 and was read as Latin-1");
        layout.says.assign(fields.size(), {});
        for (std::size_t i = 0; i < fields.size(); ++i) {
            layout.says[i].unit = name_with_unit(layout.columns.names[i]).unit;
            if (!layout.says[i].unit.empty()) layout.says[i].unit_where = fmt::format("header, line {}", line_number);
        }
    }

    void take_units(const Row& row) {
        for (std::size_t i = 0; i < std::min(row.fields.size(), layout.says.size()); ++i) {
            const std::string_view unit = row.fields[i];
            if (unit.empty() || says_no_unit(unit)) continue;
            layout.says[i].unit = shown(unit);
            if (layout.says[i].unit.size() > 2 && std::string_view("[({").find(unit.front()) != std::string_view::npos)
                layout.says[i].unit = layout.says[i].unit.substr(1, layout.says[i].unit.size() - 2);
            layout.says[i].unit_where = fmt::format("row of units, line {}", number_of(row));
        }
    }

    void take_header_rows(std::size_t top) {
        std::size_t names = top;
        for (std::size_t i = top; i < table; ++i)
            if (names_score(rows[i], wanted, layout.dialect, table - top == 1) >
                names_score(rows[names], wanted, layout.dialect, table - top == 1))
                names = i;
        take_names(rows[names].fields, number_of(rows[names]), true);
        preamble = rows[std::min(names, top)].line;
        std::optional<std::size_t> units;
        for (std::size_t i = top; i < table; ++i)
            if (i != names && is_units_row(rows[i])) units = i;
        if (units) take_units(rows[*units]);
        for (std::size_t i = names + 1; i < table; ++i)
            if (i != units)
                layout.notes.push_back(fmt::format("line {} below the names was not used: {}", number_of(rows[i]),
                                                   shown(lines[rows[i].line].text)));
        preamble = rows[names].line;
    }

    /// The row above has another number of fields: one delimiter too many or too few, or it is no header of this table.
    bool take_uneven_header() {
        Fields fields = rows[table - 1].fields;
        const auto last_is_empty = [](const Row& row) { return row.fields.back().empty(); };
        if (fields.size() == width + 1 && fields.back().empty())
            fields.pop_back();
        else if (fields.size() + 1 == width && layout.dialect.delimiter != ' ' &&
                 std::all_of(rows.begin() + static_cast<std::ptrdiff_t>(table), rows.end(), last_is_empty))
            layout.dialect.trailing_delimiter = true;
        else if (fields.size() < 2 || names_are_numbers())
            return false;
        take_names(fields, number_of(rows[table - 1]), true);
        preamble = rows[table - 1].line;
        return true;
    }

    /// All of the wanted columns are numbers: the file needs no header.
    bool names_are_numbers() const {
        return !wanted.empty() && std::all_of(wanted.begin(), wanted.end(), [](const std::string& name) {
            return !name.empty() && name.find_first_not_of("0123456789") == std::string::npos;
        });
    }

    /// "# time,a,b" right above the table, as programs that write tables of numbers put it.
    bool take_comment_header() {
        for (std::size_t i = rows[table].line; i-- > 0;) {
            const std::string& text = lines[i].text;
            const std::size_t begin = text.find_first_not_of("#%/ \t");
            if (begin == std::string::npos) continue;
            if (!is_comment(text)) return false;
            Fields fields;
            split_fields(std::string_view(text).substr(begin), layout.dialect.delimiter, fields);
            const std::set<std::string_view> different(fields.begin(), fields.end());
            if (fields.size() != width || different.size() != width) return false;
            for (const std::string_view field : fields)
                if (field.empty() || cell_of(field, layout.dialect) == Cell::number) return false;
            take_names(fields, lines[i].number, true);
            layout.notes.push_back(fmt::format("line {} is a comment and was taken for the header", lines[i].number));
            preamble = i;
            return true;
        }
        return false;
    }

    void take_numbers_for_names() {
        layout.columns = {.names = {}, .has_header = false, .line = number_of(rows[table])};
        for (std::size_t i = 1; i <= width; ++i) layout.columns.names.push_back(std::to_string(i));
        layout.says.assign(width, {});
        preamble = rows[table].line;
    }

    void find_header() {
        std::size_t top = table;
        while (top > 0 && rows[top - 1].fields.size() == width &&
               (top == table || rows[top - 1].line + 1 == rows[top].line))
            --top;
        if (top < table)
            take_header_rows(top);
        else if (!take_comment_header() && (table == 0 || !take_uneven_header()))
            take_numbers_for_names();
    }

    /// A sign that was taken for the decimal one may stand between thousands.
    void regroup() {
        CsvDialect& dialect = layout.dialect;
        GroupingWatch& watch = layout.watch;
        double value = 0.0;
        for (std::size_t i = table; i < rows.size(); ++i)
            for (std::size_t j = 0; j < std::min(width, rows[i].fields.size()); ++j)
                if (parse_field(rows[i].fields[j], dialect, value) == FieldKind::number && !std::isnan(value))
                    watch.observe(j, rows[i].fields[j]);
        for (std::size_t j = 0; j < width; ++j) {
            if (!watch.doubtful(j) || watch.any_settled()) continue;
            layout.notes.push_back(
                fmt::format("'{}' in column '{}' was read as thousands: other numbers of the column have no such sign",
                            watch.example(j), shown(layout.columns.names[j])));
            dialect.decimal_comma = !dialect.decimal_comma;
            dialect.grouped = true;
            return;
        }
    }

    void read_the_preamble() {
        std::vector<NumberedLine> above(lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(preamble));
        for (NumberedLine& line : above) {
            bool converted = false;
            line.text = to_utf8(line.text.substr(0, 400), converted);
        }
        layout.preamble = read_preamble(above);
    }

    /// A name after the last delimiter is missing because there is no column: no row has anything there.
    void drop_trailing_column() {
        const bool trailing = layout.dialect.delimiter != ' ' && layout.columns.has_header &&
                              layout.columns.names.size() > 1 && layout.columns.names.back().empty() &&
                              std::all_of(rows.begin() + static_cast<std::ptrdiff_t>(table), rows.end(),
                                          [](const Row& row) { return row.fields.back().empty(); });
        if (!trailing) return;
        layout.dialect.trailing_delimiter = true;
        layout.columns.names.pop_back();
        layout.says.pop_back();
    }
};

}  // namespace

CsvLayout find_layout(const std::vector<NumberedLine>& lines, const std::vector<std::string>& wanted) {
    Builder builder{lines, wanted, {}, {}};
    const char forced = stated_delimiter(lines.front().text);
    builder.split_rows(forced ? 1 : 0, forced);
    if (builder.rows.empty()) return builder.layout;
    builder.layout.watch = GroupingWatch(builder.width, builder.layout.dialect.decimal());
    if (builder.find_table()) {
        builder.find_header();
        builder.regroup();
    } else {
        builder.take_names(builder.rows.front().fields, builder.number_of(builder.rows.front()), true);
        builder.table = 1;
    }
    builder.read_the_preamble();
    CsvLayout& layout = builder.layout;
    layout.first_row = builder.table < builder.rows.size() ? builder.rows[builder.table].line : lines.size();
    builder.drop_trailing_column();
    return layout;
}

}  // namespace railpem::recordings
