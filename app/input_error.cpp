#include "app/input_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace railpem::app {

namespace {

/// The line as code points that a terminal can show: control characters and broken UTF-8 become '?', tabs a space.
std::vector<std::string> printable_characters(const std::string& line) {
    std::vector<std::string> characters;
    for (std::size_t i = 0; i < line.size();) {
        const unsigned char lead = static_cast<unsigned char>(line[i]);
        std::size_t length = lead < 0x80   ? 1
                             : lead < 0xC2 ? 0
                             : lead < 0xE0 ? 2
                             : lead < 0xF0 ? 3
                             : lead < 0xF5 ? 4
                                           : 0;
        for (std::size_t k = 1; k < length; ++k)
            if (i + k >= line.size() || (static_cast<unsigned char>(line[i + k]) & 0xC0) != 0x80) length = 0;
        const bool control = lead < 0x20 || lead == 0x7F;
        characters.push_back(lead == '\t' ? " " : length == 0 || control ? "?" : line.substr(i, length));
        i += std::max<std::size_t>(length, 1);
    }
    return characters;
}

/// The source line and the carets under it; of a long line only the part around the carets.
std::string excerpt(const std::string& source_line, const Place& place) {
    constexpr std::size_t kWidth = 100;
    const std::vector<std::string> characters = printable_characters(source_line);
    const std::size_t marked = std::min(place.column > 0 ? place.column - 1 : 0, characters.size());
    const std::size_t first = marked > kWidth / 2 && characters.size() > kWidth ? marked - kWidth / 2 : 0;
    const std::size_t last = std::min(characters.size(), first + kWidth);
    std::string text;
    for (std::size_t i = first; i < last; ++i) text += characters[i];
    const std::size_t longest = std::max<std::size_t>(last - marked, 1);
    const std::size_t carets = std::clamp<std::size_t>(place.length, 1, longest);
    const std::string number = std::to_string(place.line);
    return fmt::format("\n  {} | {}\n  {} | {}{}", number, text, std::string(number.size(), ' '),
                       std::string(marked - first, ' '), std::string(carets, '^'));
}

}  // namespace

InputError input_error(const std::string& file, const std::string& source_line, const Place& place,
                       const Problem& problem) {
    std::string message;
    if (!place.option.empty())
        message = fmt::format("{}: {}", place.option, problem.what);
    else if (place.line == 0)
        message = fmt::format("{}: {}", file, problem.what);
    else
        message =
            fmt::format("{}:{}:{}: {}{}", file, place.line, place.column, problem.what, excerpt(source_line, place));
    if (!problem.allowed.empty()) message += "\nallowed: " + problem.allowed;
    if (!problem.hint.empty()) message += "\n" + problem.hint;
    return InputError(message);
}

}  // namespace railpem::app
