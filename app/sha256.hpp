#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace railpem::app {

/// SHA-256 (FIPS 180-4) as 64 hexadecimal digits, like `sha256sum` prints it.
std::string sha256(std::string_view text);

/// That of a file; empty where it cannot be read (a pipe has been read already) or is no regular file.
std::string sha256_of_file(const std::filesystem::path& file);

}  // namespace railpem::app
