#include "recordings/files/text_encoding.hpp"

namespace railpem::recordings {

bool is_utf8(std::string_view text) {
    for (std::size_t i = 0; i < text.size();) {
        const auto lead = static_cast<unsigned char>(text[i]);
        const std::size_t length = lead < 0x80                      ? 1
                                   : (lead >= 0xC2 && lead <= 0xDF) ? 2
                                   : (lead & 0xF0) == 0xE0          ? 3
                                   : (lead >= 0xF0 && lead <= 0xF4) ? 4
                                                                    : 0;
        if (length == 0 || i + length > text.size()) return false;
        for (std::size_t j = 1; j < length; ++j)
            if ((static_cast<unsigned char>(text[i + j]) & 0xC0) != 0x80) return false;
        i += length;
    }
    return true;
}

std::string to_utf8(std::string_view text, bool& converted) {
    if (is_utf8(text)) return std::string(text);
    converted = true;
    std::string result;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x80) {
            result += c;
        } else {
            result += static_cast<char>(0xC0 | (byte >> 6));
            result += static_cast<char>(0x80 | (byte & 0x3F));
        }
    }
    return result;
}

}  // namespace railpem::recordings
