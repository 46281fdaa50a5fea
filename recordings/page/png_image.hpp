#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace railpem::recordings {

/// A picture of width × height colours (3 bytes each, rows from the top) as a PNG file.
std::string png_image(std::size_t width, std::size_t height, const std::vector<std::uint8_t>& colours);

/// Bytes as base 64 text, for a data: address.
std::string base64(const std::string& bytes);

}  // namespace railpem::recordings
