#include "recordings/page/png_image.hpp"

#include <zlib.h>

#include <cassert>

namespace railpem::recordings {
namespace {

void append_word(std::string& out, std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) out += static_cast<char>((value >> shift) & 0xFF);
}

void append_chunk(std::string& out, const std::string& kind, const std::string& content) {
    append_word(out, static_cast<std::uint32_t>(content.size()));
    const std::string checked = kind + content;
    out += checked;
    append_word(out, static_cast<std::uint32_t>(
                         crc32(0, reinterpret_cast<const Bytef*>(checked.data()), static_cast<uInt>(checked.size()))));
}

}  // namespace

std::string png_image(std::size_t width, std::size_t height, const std::vector<std::uint8_t>& colours) {
    assert(colours.size() == 3 * width * height && width > 0 && height > 0);
    std::string rows;
    for (std::size_t y = 0; y < height; ++y) {
        rows += '\0';  // no filter
        rows.append(reinterpret_cast<const char*>(colours.data()) + 3 * width * y, 3 * width);
    }
    uLongf size = compressBound(static_cast<uLong>(rows.size()));
    std::string compressed(size, '\0');
    [[maybe_unused]] const int done =
        compress2(reinterpret_cast<Bytef*>(compressed.data()), &size, reinterpret_cast<const Bytef*>(rows.data()),
                  static_cast<uLong>(rows.size()), 9);
    assert(done == Z_OK);
    compressed.resize(size);
    std::string header;
    append_word(header, static_cast<std::uint32_t>(width));
    append_word(header, static_cast<std::uint32_t>(height));
    header += std::string("\x08\x02\x00\x00\x00", 5);  // 8 bits, true colour
    std::string out("\x89PNG\r\n\x1A\n", 8);
    append_chunk(out, "IHDR", header);
    append_chunk(out, "IDAT", compressed);
    append_chunk(out, "IEND", "");
    return out;
}

std::string base64(const std::string& bytes) {
    static const char* const digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k)
            group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
        for (std::size_t k = 0; k < 4; ++k) out += i + k <= bytes.size() ? digits[(group >> (18 - 6 * k)) & 63] : '=';
    }
    return out;
}

}  // namespace railpem::recordings
