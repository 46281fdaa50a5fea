#include "recordings/files/data_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>

#include "recordings/files/read_error.hpp"
#include "recordings/files/visible_text.hpp"

namespace railpem::recordings {
namespace {

std::size_t edit_distance(const std::string& a, const std::string& b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t substituted = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({row[j] + 1, row[j - 1] + 1, substituted});
        }
    }
    return row[b.size()];
}

}  // namespace

std::string nearest_name(const std::string& wanted, const std::vector<std::string>& names) {
    std::string nearest;
    std::size_t best = std::max<std::size_t>(2, wanted.size() / 2);
    for (const std::string& name : names) {
        if (name.size() > 200) continue;  // binary rubbish taken for a header: comparing it would only cost time
        const std::size_t distance = edit_distance(wanted, name);
        if (distance < best) {
            best = distance;
            nearest = name;
        }
    }
    return nearest;
}

std::string listed(const std::vector<std::string>& names) {
    constexpr std::size_t shown = 12;
    if (names.empty()) return "nothing";
    std::vector<std::string> first(names.begin(), names.begin() + std::min(shown, names.size()));
    for (std::string& name : first)
        if (name.empty())
            name = "(a column without a name)";
        else
            name = visible(name.size() > 60 ? name.substr(0, 57) + "..." : name);
    const std::string words = fmt::format("{}", fmt::join(first, ", "));
    return names.size() > shown ? fmt::format("{} … ({} in all)", words, names.size()) : words;
}

std::size_t require_name(const std::string& wanted, const std::vector<std::string>& names, const std::string& what,
                         const std::string& file, std::size_t line) {
    const auto found = std::find(names.begin(), names.end(), wanted);
    if (found == names.end()) {
        const std::string nearest = nearest_name(wanted, names);
        throw ReadError(file, line,
                        fmt::format("there is no {} '{}'{}", what, wanted,
                                    nearest.empty() ? "" : fmt::format(" (did you mean '{}'?)", visible(nearest))),
                        listed(names));
    }
    if (std::find(found + 1, names.end(), wanted) != names.end())
        throw ReadError(file, line, fmt::format("there are two {}s named '{}'", what, wanted),
                        "a name of its own for every one that is used");
    return static_cast<std::size_t>(found - names.begin());
}

}  // namespace railpem::recordings
