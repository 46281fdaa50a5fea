#pragma once

#include <string>
#include <string_view>

namespace railpem::recordings {

/// The text as UTF-8: unchanged when it is UTF-8 already, else its bytes read as Latin-1; `converted` is set then.
std::string to_utf8(std::string_view text, bool& converted);

/// True for well-formed UTF-8.
bool is_utf8(std::string_view text);

}  // namespace railpem::recordings
