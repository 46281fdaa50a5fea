#include "app/schema/nearest_key.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace railpem::app {

namespace {

/// Words that units in keys are made of, the ones used here and those that somebody else may have used.
constexpr auto kUnitWords = std::to_array<std::string_view>(
    {"m",  "mm",  "cm", "km",  "um",  "m2",  "m3",  "m4",     "mm2",    "mm4",     "cm2",   "cm3", "cm4", "n23", "kg",
     "g",  "t",   "n",  "kn",  "mn",  "s",   "s2",  "ms",     "h",      "min",     "per",   "pa",  "kpa", "mpa", "gpa",
     "hz", "khz", "db", "rad", "deg", "kmh", "mps", "cycles", "octave", "percent", "ratio", "nm",  "lb",  "in",  "ft"});

bool is_unit_word(std::string_view word) {
    return std::find(kUnitWords.begin(), kUnitWords.end(), word) != kUnitWords.end();
}

}  // namespace

std::size_t edit_distance(const std::string& a, const std::string& b) {
    std::vector<std::size_t> before(b.size() + 1), previous(b.size() + 1), current(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) previous[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        current[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = previous[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            current[j] = std::min({previous[j] + 1, current[j - 1] + 1, replaced});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                current[j] = std::min(current[j], before[j - 2] + 1);
        }
        std::swap(before, previous);
        std::swap(previous, current);
    }
    return previous[b.size()];
}

std::string without_unit(const std::string& key) {
    std::string stem = key;
    for (std::size_t at = stem.rfind('_'); at != std::string::npos && at > 0; at = stem.rfind('_')) {
        if (!is_unit_word(std::string_view(stem).substr(at + 1))) break;
        stem.resize(at);
    }
    return stem;
}

namespace {

std::string in_small_letters(std::string text) {
    for (char& letter : text) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    return text;
}

}  // namespace

std::string nearest_key(const std::string& unknown, const std::vector<std::string>& known) {
    for (const std::string& key : known)
        if (key != unknown && in_small_letters(key) == in_small_letters(unknown)) return key;
    const std::string stem = without_unit(unknown);
    std::string nearest;
    std::size_t least = std::string::npos;
    for (const std::string& key : known) {
        if (without_unit(key) == stem && key != stem) return key;
        const std::size_t distance = edit_distance(unknown, key);
        if (distance <= std::max<std::size_t>(1, key.size() / 3) && distance < least) {
            least = distance;
            nearest = key;
        }
    }
    return nearest;
}

std::string did_you_mean(const std::string& unknown, const std::vector<std::string>& known) {
    const std::string near = nearest_key(unknown, known);
    return near.empty() ? "" : fmt::format("did you mean '{}'?", near);
}

std::string joined(const std::vector<std::string>& names) {
    return fmt::format("{}", fmt::join(names, ", "));
}

InputError unknown_name(const std::string& option, const std::string& what, const std::string& name,
                        const std::vector<std::string>& known) {
    return input_error("", "", {.option = option},
                       {.what = fmt::format("unknown {} '{}'", what, name),
                        .allowed = joined(known),
                        .hint = did_you_mean(name, known)});
}

}  // namespace railpem::app
