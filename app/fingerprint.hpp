#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace railpem::app {

/// FNV-1a, 64 bits: tells texts apart, no defence against malice.
std::uint64_t fingerprint(std::string_view text);

/// The same as sixteen hexadecimal digits.
std::string fingerprint_text(std::string_view text);

}  // namespace railpem::app
