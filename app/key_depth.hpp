#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace railpem::app {

/// Names that a dotted key or the header of a table may have: a case needs five.
inline constexpr std::size_t kDeepestKey = 32;

/// The line (from 1) of the first dotted key or header with more names than kDeepestKey, looked for in the text alone,
/// outside of strings and comments: a parser that goes down name by name would leave its stack. Nothing where all are
/// shallow.
std::optional<std::size_t> line_of_deep_key(std::string_view toml);

}  // namespace railpem::app
