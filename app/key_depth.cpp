#include "app/key_depth.hpp"

#include <algorithm>
#include <cstring>
#include <string>

namespace railpem::app {

namespace {

/// Behind the end of a string that begins at `at`, of any of the four kinds of TOML.
std::size_t behind_string(std::string_view text, std::size_t at) {
    const char quote = text[at];
    const bool long_one = text.substr(at, 3) == std::string(3, quote);
    for (std::size_t i = at + (long_one ? 3 : 1); i < text.size(); ++i) {
        if (text[i] == '\\' && quote == '"')
            ++i;
        else if (!long_one && (text[i] == quote || text[i] == '\n'))
            return i + 1;
        else if (long_one && text.substr(i, 3) == std::string(3, quote))
            return i + 3;
    }
    return text.size();
}

/// Characters that go on with a dotted key: of names without quotes, and blanks around the dots.
bool goes_on(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || std::strchr("_- \t", c);
}

}  // namespace

std::optional<std::size_t> line_of_deep_key(std::string_view toml) {
    std::size_t dots = 0;
    for (std::size_t i = 0; i < toml.size();) {
        const char c = toml[i];
        if (c == '"' || c == '\'') {
            i = behind_string(toml, i);
            continue;
        }
        if (c == '#') i = std::min(toml.find('\n', i), toml.size());
        if (i == toml.size()) break;
        if (toml[i] == '.' && ++dots >= kDeepestKey)
            return static_cast<std::size_t>(
                       std::count(toml.begin(), toml.begin() + static_cast<std::ptrdiff_t>(i), '\n')) +
                   1;
        if (toml[i] != '.' && (toml[i] == '\0' || !goes_on(toml[i]))) dots = 0;
        ++i;
    }
    return std::nullopt;
}

}  // namespace railpem::app
