#pragma once

#include <charconv>
#include <cstddef>
#include <string>

namespace railpem::recordings {

/// `data:3` → {"data", 3}; `data` → {"data", 0}.
struct NamedColumn {
    std::string name;
    std::size_t column = 0;  ///< from 1; 0: the whole is one column
};

inline NamedColumn named_column(const std::string& text) {
    const std::size_t colon = text.rfind(':');
    if (colon == std::string::npos || colon + 1 == text.size()) return {text, 0};
    std::size_t column = 0;
    const auto [stop, error] = std::from_chars(text.data() + colon + 1, text.data() + text.size(), column);
    if (error != std::errc() || stop != text.data() + text.size()) return {text, 0};
    return {text.substr(0, colon), column};
}

}  // namespace railpem::recordings
