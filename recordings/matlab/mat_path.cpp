#include "recordings/matlab/mat_path.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>

#include "recordings/files/data_table.hpp"
#include "recordings/files/named_column.hpp"
#include "recordings/files/read_error.hpp"

namespace railpem::recordings {
namespace {

constexpr std::size_t every = 0;  ///< a colon in place of an index

/// `.field`, or an index in parentheses or braces: one number or one per dimension, from 1.
struct Step {
    std::string field;
    std::vector<std::size_t> index;
    std::size_t end = 0;  ///< of the step in the path
};

struct Path {
    std::string variable;
    std::vector<Step> steps;
    std::size_t channel = 0;  ///< behind a colon, from 1; 0: none
};

/// `2`, `2,1`, `:,3`, `3,:`; nothing for anything else.
std::optional<std::vector<std::size_t>> index_of(std::string_view text) {
    std::vector<std::size_t> index;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        std::string_view part = text.substr(begin, end - begin);
        while (!part.empty() && part.front() == ' ') part.remove_prefix(1);
        while (!part.empty() && part.back() == ' ') part.remove_suffix(1);
        std::size_t value = every;
        if (part != ":") {
            const auto [stop, error] = std::from_chars(part.data(), part.data() + part.size(), value);
            if (error != std::errc() || stop != part.data() + part.size() || value == 0) return std::nullopt;
        }
        index.push_back(value);
        begin = end + 1;
    }
    return index;
}

std::optional<Path> parsed(const std::string& text) {
    static const char* const marks = ".({";
    const NamedColumn named = named_column(text);
    const std::string& all = named.name;
    Path path;
    path.channel = named.column;
    std::size_t at = std::min(all.find_first_of(marks), all.size());
    path.variable = all.substr(0, at);
    while (at < all.size()) {
        Step step;
        if (all[at] == '.') {
            step.end = std::min(all.find_first_of(marks, at + 1), all.size());
            step.field = all.substr(at + 1, step.end - at - 1);
            if (step.field.empty()) return std::nullopt;
        } else {
            const std::size_t close = all.find(all[at] == '(' ? ')' : '}', at);
            if (close == std::string::npos) return std::nullopt;
            const auto index = index_of(std::string_view(all).substr(at + 1, close - at - 1));
            if (!index) return std::nullopt;
            step.index = *index;
            step.end = close + 1;
            if (step.end < all.size() && std::string_view(marks).find(all[step.end]) == std::string_view::npos)
                return std::nullopt;
        }
        at = step.end;
        path.steps.push_back(std::move(step));
    }
    return path;
}

std::string shape(const MatValue& value) {
    return fmt::format("{}", fmt::join(value.sizes, " x "));
}

std::string what_it_is(const MatValue& value) {
    if (value.kind != MatKind::object && value.elements() == 0) return fmt::format("empty ({})", shape(value));
    switch (value.kind) {
        case MatKind::numbers:
            return fmt::format("numbers ({})", shape(value));
        case MatKind::complex:
            return fmt::format("complex ({})", shape(value));
        case MatKind::text:
            return "text";
        case MatKind::cell:
            return fmt::format("a cell array ({})", shape(value));
        case MatKind::structure:
            return value.elements() == 1 ? "a structure" : fmt::format("an array of structures ({})", shape(value));
        case MatKind::sparse:
            return fmt::format("a sparse matrix ({})", shape(value));
        case MatKind::object:
            break;
    }
    return fmt::format("an object of MATLAB (class {})", value.class_name);
}

std::string what_would_do(const MatValue& value, const std::string& name) {
    if (value.kind != MatKind::object && value.elements() == 0) return "a variable that holds samples";
    const std::size_t count = value.elements();
    switch (value.kind) {
        case MatKind::complex:
            return fmt::format("real numbers: real({0}), imag({0}) or abs({0}) saved under a name of its own", name);
        case MatKind::cell:
            return fmt::format("its elements, {0}{{1}} to {0}{{{1}}}", name, count);
        case MatKind::structure: {
            std::vector<std::string> fields;
            for (const std::string& field : value.fields)
                fields.push_back(fmt::format("{}{}.{}", name, count > 1 ? "(1)" : "", field));
            return fmt::format("its fields, {}{}", listed(fields),
                               count > 1 ? fmt::format(", and so on to ({})", count) : "");
        }
        case MatKind::sparse:
            return fmt::format("a full matrix: full({})", name);
        case MatKind::object:
            return fmt::format("numbers: of a table for instance {}{{:,:}} saved under a name of its own", name);
        case MatKind::numbers:
        case MatKind::text:
            break;
    }
    return "a vector, or a matrix of a column per channel";
}

/// Walks a path through the values of a file and says where it leads nowhere.
class Walk {
  public:
    Walk(const std::string& file, const std::string& path) : file_(file), path_(path) {}

    [[noreturn]] void fail(const std::string& problem, const std::string& allowed) const {
        throw ReadError(file_, 0, problem, allowed);
    }

    const MatValue& field(const MatValue& value, const Step& step, const std::string& before) const {
        if (value.kind != MatKind::structure)
            fail(fmt::format("'{}' is {}, it has no fields", before, what_it_is(value)), what_would_do(value, before));
        if (value.elements() != 1)
            fail(fmt::format("'{}' is {}, and '{}' does not say which of them", before, what_it_is(value), path_),
                 fmt::format("{0}(1){1} to {0}({2}){1}", before,
                             path_.substr(before.size(), path_.rfind(':') - before.size()), value.elements()));
        return member(value, 0, step, before);
    }

    const MatValue& member(const MatValue& value, std::size_t element, const Step& step,
                           const std::string& before) const {
        const std::size_t at =
            require_name(step.field, value.fields, fmt::format("field of '{}' called", before), file_, 0);
        return value.parts[element * value.fields.size() + at];
    }

    /// Number of the element that the index names, from 0.
    std::size_t element(const MatValue& value, const Step& step, const std::string& before) const {
        std::size_t at = 0, stride = 1;
        bool there = step.index.size() == 1 || step.index.size() == value.sizes.size();
        for (std::size_t i = 0; there && i < step.index.size(); ++i) {
            const std::size_t most = step.index.size() == 1 ? value.elements() : value.sizes[i];
            there = step.index[i] != every && step.index[i] <= most;
            at += (step.index[i] - 1) * stride;
            stride *= most;
        }
        if (!there)
            fail(
                fmt::format("'{}' has no element '{}': it is {}", before, path_.substr(0, step.end), what_it_is(value)),
                what_would_do(value, before));
        return at;
    }

  private:
    const std::string& file_;
    const std::string& path_;
};

/// Sizes other than one: {}, {samples} or {rows, columns}.
std::vector<std::size_t> long_sides(const MatValue& value) {
    std::vector<std::size_t> sides;
    for (const std::size_t size : value.sizes)
        if (size != 1) sides.push_back(size);
    return sides;
}

MatColumn matrix_row(const MatValue& value, std::size_t row, std::size_t rows, std::size_t columns) {
    return {value.stored, row, rows, columns};
}

MatColumn matrix_column(const MatValue& value, std::size_t column, std::size_t rows) {
    return {value.stored, column * rows, 1, rows};
}

/// `(:,3)` or `(3,:)` of a matrix.
MatColumn sliced(const MatValue& value, const Step& slice, const std::string& name, const Walk& walk) {
    const std::vector<std::size_t>& at = slice.index;
    const bool column = at.size() == 2 && at[0] == every, row = at.size() == 2 && at[1] == every;
    if (value.sizes.size() != 2 || column == row || at[column ? 1 : 0] > value.sizes[column ? 1 : 0])
        walk.fail(fmt::format("'{}' is {}: it has no such part", name, what_it_is(value)),
                  fmt::format("{0}(:,1) for a column, {0}(1,:) for a row", name));
    if (value.sizes[column ? 0 : 1] < 2)
        walk.fail(fmt::format("'{}' is {}: that part is a single number, no samples", name, what_it_is(value)),
                  "a vector, or a matrix of a column per channel");
    return column ? matrix_column(value, at[1] - 1, value.sizes[0])
                  : matrix_row(value, at[0] - 1, value.sizes[0], value.sizes[1]);
}

MatColumn channel_of(const MatValue& value, std::size_t channel, const std::string& name, const Walk& walk,
                     std::vector<std::string>& notes) {
    const std::vector<std::size_t> sides = long_sides(value);
    if (value.kind != MatKind::numbers || value.elements() == 0)
        walk.fail(fmt::format("the variable '{}' is {}", name, what_it_is(value)), what_would_do(value, name));
    if (sides.empty())
        walk.fail(fmt::format("the variable '{}' is a single number, no samples", name),
                  "a vector, or a matrix of a column per channel");
    if (sides.size() > 2)
        walk.fail(fmt::format("the variable '{}' has more than two dimensions ({})", name, shape(value)),
                  "a vector, or a matrix of a column per channel");
    if (sides.size() == 1) {
        if (channel > 1) walk.fail(fmt::format("the variable '{}' has no column {}", name, channel), name);
        return matrix_column(value, 0, sides[0]);
    }
    const std::size_t channels = std::min(sides[0], sides[1]);
    const bool by_rows = sides[0] < sides[1];
    const std::string allowed = fmt::format("{0}:1 to {0}:{1}", name, channels);
    if (channel == 0)
        walk.fail(fmt::format("the variable '{}' is a matrix of {} {}", name, channels, by_rows ? "rows" : "columns"),
                  allowed);
    if (channel > channels)
        walk.fail(
            fmt::format("the variable '{}' has no {} {} ({})", name, by_rows ? "row" : "column", channel, shape(value)),
            allowed);
    if (!by_rows) return matrix_column(value, channel - 1, sides[0]);
    const std::string note = fmt::format("the rows of '{}' ({}) were taken for its channels", name, shape(value));
    if (std::find(notes.begin(), notes.end(), note) == notes.end()) notes.push_back(note);
    return matrix_row(value, channel - 1, sides[0], sides[1]);
}

/// Calls `visit(path, value)` for every value that is not made of others.
template <class Visit>
void for_leaves(const MatValue& value, const std::string& path, const Visit& visit) {
    if (value.kind == MatKind::cell) {
        for (std::size_t i = 0; i < value.parts.size(); ++i)
            for_leaves(value.parts[i], fmt::format("{}{{{}}}", path, i + 1), visit);
    } else if (value.kind == MatKind::structure) {
        const std::size_t fields = value.fields.size();
        for (std::size_t i = 0; i < value.parts.size(); ++i)
            for_leaves(value.parts[i],
                       value.elements() > 1 ? fmt::format("{}({}).{}", path, i / fields + 1, value.fields[i % fields])
                                            : path + "." + value.fields[i % fields],
                       visit);
    } else {
        visit(path, value);
    }
}

/// The value that a path without brackets names to the letter, whatever stands in its names.
const MatValue* named_to_the_letter(const std::vector<MatVariable>& variables, const std::string& name) {
    const MatValue* found = nullptr;
    for (const MatVariable& variable : variables)
        if (name.starts_with(variable.name))
            for_leaves(variable.value, variable.name, [&](const std::string& path, const MatValue& value) {
                if (path == name && !found) found = &value;
            });
    return found;
}

}  // namespace

MatColumn find_mat_column(const std::vector<MatVariable>& variables, const std::string& text, const std::string& file,
                          std::vector<std::string>& notes) {
    const Walk walk(file, text);
    const NamedColumn named = named_column(text);
    if (const MatValue* value = named_to_the_letter(variables, named.name))
        return channel_of(*value, named.column, named.name, walk, notes);
    const std::optional<Path> path = parsed(text);
    const auto known = std::find_if(variables.begin(), variables.end(),
                                    [&](const MatVariable& v) { return path && v.name == path->variable; });
    if (known == variables.end()) {
        std::vector<std::string> names = mat_number_paths(variables);
        require_name(named.name, names, "variable", file, 0);
    }
    const MatValue* value = &known->value;
    std::string before = known->name;
    for (std::size_t i = 0; i < path->steps.size(); ++i) {
        const Step& step = path->steps[i];
        if (!step.field.empty()) {
            value = &walk.field(*value, step, before);
        } else if (value->kind == MatKind::cell) {
            value = &value->parts[walk.element(*value, step, before)];
        } else if (value->kind == MatKind::structure) {
            const std::size_t element = walk.element(*value, step, before);
            if (++i == path->steps.size() || path->steps[i].field.empty())
                walk.fail(fmt::format("'{}' is a structure", text.substr(0, step.end)), what_would_do(*value, before));
            value = &walk.member(*value, element, path->steps[i], text.substr(0, step.end));
        } else if (value->kind == MatKind::numbers && i + 1 == path->steps.size() && path->channel == 0) {
            return sliced(*value, step, before, walk);
        } else {
            walk.fail(
                fmt::format("'{}' is {}: it has no element '{}'", before, what_it_is(*value), text.substr(0, step.end)),
                what_would_do(*value, before));
        }
        before = text.substr(0, path->steps[std::min(i, path->steps.size() - 1)].end);
    }
    return channel_of(*value, path->channel, before, walk, notes);
}

std::vector<std::string> mat_number_paths(const std::vector<MatVariable>& variables) {
    std::vector<std::string> paths;
    for (const MatVariable& variable : variables)
        for_leaves(variable.value, variable.name, [&](const std::string& path, const MatValue& value) {
            if (value.kind == MatKind::numbers && value.elements() > 0) paths.push_back(path);
        });
    return paths;
}

std::vector<std::string> mat_channel_paths(const std::vector<MatVariable>& variables) {
    std::vector<std::string> paths;
    for (const MatVariable& variable : variables)
        for_leaves(variable.value, variable.name, [&](const std::string& path, const MatValue& value) {
            const std::vector<std::size_t> sides = long_sides(value);
            if (value.kind != MatKind::numbers || value.elements() < 2 || sides.size() > 2) return;
            if (sides.size() == 1) paths.push_back(path);
            for (std::size_t i = 0; sides.size() == 2 && i < std::min(sides[0], sides[1]); ++i)
                paths.push_back(fmt::format("{}:{}", path, i + 1));
        });
    return paths;
}

}  // namespace railpem::recordings
