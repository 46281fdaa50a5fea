#include "recordings/text/column_address.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>

#include "recordings/files/data_table.hpp"
#include "recordings/files/known_units.hpp"
#include "recordings/files/named_column.hpp"
#include "recordings/files/read_error.hpp"

namespace railpem::recordings {
namespace {

std::vector<std::size_t> called(const std::string& name, const std::vector<std::string>& names) {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < names.size(); ++i)
        if (names[i] == name) found.push_back(i);
    return found;
}

/// The whole text as a number of a column, from 1; 0 when it is none.
std::size_t as_number(const std::string& text) {
    std::size_t number = 0;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && stop == text.data() + text.size() ? number : 0;
}

std::vector<std::string> without_units(const std::vector<std::string>& names) {
    std::vector<std::string> plain;
    for (const std::string& name : names) plain.push_back(name_with_unit(name).name);
    return plain;
}

[[noreturn]] void refuse_ambiguous(const std::string& wanted, const std::vector<std::size_t>& found,
                                   const ColumnNames& columns, const std::string& file) {
    std::vector<std::string> addresses;
    std::vector<std::size_t> numbers;
    for (std::size_t i = 0; i < std::min<std::size_t>(found.size(), 6); ++i) {
        addresses.push_back(fmt::format("{}:{}", wanted, i + 1));
        numbers.push_back(found[i] + 1);
    }
    const char* more = found.size() > numbers.size() ? " …" : "";
    throw ReadError(file, columns.line, fmt::format("there are {} columns named '{}'", found.size(), wanted),
                    fmt::format("column = \"{}\"{}, or their numbers: \"{}\"{}", fmt::join(addresses, "\", \""), more,
                                fmt::join(numbers, "\", \""), more));
}

}  // namespace

std::size_t find_column(const std::string& wanted, const ColumnNames& columns, const std::string& file) {
    for (const auto& names : {columns.names, without_units(columns.names)}) {
        const std::vector<std::size_t> found = called(wanted, names);
        if (found.size() == 1) return found.front();
        if (found.size() > 1) refuse_ambiguous(wanted, found, columns, file);
        const NamedColumn which = named_column(wanted);
        const std::vector<std::size_t> all = called(which.name, names);
        if (which.column >= 1 && which.column <= all.size()) return all[which.column - 1];
    }
    const std::size_t number = as_number(wanted);
    if (number >= 1 && number <= columns.names.size()) return number - 1;
    if (!columns.has_header)
        throw ReadError(file, columns.line,
                        fmt::format("the first row holds numbers: there is no header, and no column '{}'", wanted),
                        fmt::format("a first row with the names of the columns, or their numbers: column = \"1\" to "
                                    "\"{}\"",
                                    columns.names.size()));
    return require_name(wanted, columns.names, "column", file, columns.line);
}

std::vector<std::size_t> find_columns(const std::vector<std::string>& wanted, const ColumnNames& columns,
                                      const std::string& file) {
    std::vector<std::size_t> found;
    for (const std::string& name : wanted) {
        const std::size_t column = find_column(name, columns, file);
        if (const auto twice = std::find(found.begin(), found.end(), column); twice != found.end())
            throw ReadError(file, columns.line,
                            fmt::format("'{}' and '{}' are the same column",
                                        wanted[static_cast<std::size_t>(twice - found.begin())], name),
                            "one name or number for a column");
        found.push_back(column);
    }
    return found;
}

std::size_t columns_known(const std::vector<std::string>& wanted, const std::vector<std::string>& names) {
    const std::vector<std::string> plain = without_units(names);
    return static_cast<std::size_t>(std::count_if(wanted.begin(), wanted.end(), [&](const std::string& name) {
        const std::string own = named_column(name).column > 0 ? named_column(name).name : name;
        return !called(name, names).empty() || !called(own, names).empty() || !called(own, plain).empty();
    }));
}

}  // namespace railpem::recordings
