#include "recordings/text/missing_words.hpp"

#include <algorithm>
#include <string>

namespace railpem::recordings {
namespace {

/// Longer than every word below, with a sign and digits behind it.
constexpr std::size_t longest_word = 24;

bool is_one_of(std::string_view word) {
    static constexpr std::string_view known[] = {
        "nan",      "na",       "n/a",      "n.a.",      "null",    "none",       "nil",         "missing", "invalid",
        "inf",      "infinity", "ind",      "qnan",      "snan",    "ovl",        "ovr",         "ovf",     "ovld",
        "over",     "overload", "overflow", "overrange", "under",   "underrange", "unf",         "oor",     "bad",
        "error",    "fault",    "no data",  "nodata",    "void",    "#n/a",       "#na",         "#nv",     "#null!",
        "#div/0!",  "#value!",  "#wert!",   "#ref!",     "#bezug!", "#num!",      "#zahl!",      "#name?",  "#n/a n/a",
        "#valeur!", "#error!",  "#err",     "#nan",      "<na>",    "(null)",     "\xE2\x88\x9E"};
    return std::find(std::begin(known), std::end(known), word) != std::end(known);
}

/// "1.#IND", "1.#QNAN0", "1.#INF00": how the C library of Microsoft wrote what is not a number.
bool is_microsoft_word(std::string_view word) {
    if (word.substr(0, 3) != "1.#") return false;
    word.remove_prefix(3);
    while (!word.empty() && word.back() == '0') word.remove_suffix(1);
    return word == "ind" || word == "inf" || word == "qnan" || word == "snan" || word == "nan";
}

/// "nan(ind)", "nan(snan)", "nan(0x8000000000000)": NaN with its payload.
bool is_nan_with_payload(std::string_view word) {
    return word.substr(0, 4) == "nan(" && word.back() == ')';
}

/// "-", "---", "-.--", "***", "???": placeholders that hold no letter or digit.
bool is_placeholder(std::string_view word) {
    for (const std::string_view filler : {"-.", "*", "?"})
        if (word.find_first_not_of(filler) == std::string_view::npos && word != ".") return true;
    return false;
}

}  // namespace

bool is_missing_word(std::string_view field) {
    if (field.empty() || field.size() > longest_word) return false;
    std::string word(field);
    std::transform(word.begin(), word.end(), word.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    if (is_placeholder(word)) return true;
    std::string_view plain = word;
    if (plain.front() == '-' || plain.front() == '+') plain.remove_prefix(1);
    return is_one_of(plain) || is_microsoft_word(plain) || is_nan_with_payload(plain);
}

}  // namespace railpem::recordings
