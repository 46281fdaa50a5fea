#include "recordings/files/visible_text.hpp"

#include <fmt/format.h>

#include "recordings/files/text_encoding.hpp"

namespace railpem::recordings {
namespace {

/// The character at the front: its bytes and its code point; one byte and −1 when it is not UTF-8.
struct Character {
    std::size_t bytes = 1;
    long code = -1;
};

Character character_at(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const std::size_t length = byte(0) < 0x80 ? 1 : byte(0) < 0xE0 ? 2 : byte(0) < 0xF0 ? 3 : 4;
    if (length > text.size() || !is_utf8(text.substr(0, length))) return {};
    if (length == 1) return {1, byte(0)};
    long code = byte(0) & (0xFF >> (length + 1));
    for (std::size_t i = 1; i < length; ++i) code = (code << 6) | (byte(i) & 0x3F);
    return {length, code};
}

/// C0 and C1 controls, DEL, line and paragraph separators, and the marks of direction (Unicode 15, Bidi_Control).
bool is_hidden(long code) {
    return code < 0x20 || (code >= 0x7F && code < 0xA0) || code == 0x061C || code == 0x200E || code == 0x200F ||
           (code >= 0x2028 && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069) || code == 0xFEFF;
}

std::string shown(std::string_view text, bool keep_lines) {
    std::string out;
    out.reserve(text.size());
    while (!text.empty()) {
        const Character character = character_at(text);
        if (character.code < 0)
            out += fmt::format("\\x{:02x}", static_cast<unsigned char>(text.front()));
        else if (character.code == '\n' && !keep_lines)
            out += "\\n";
        else if (character.code == '\t')
            out += "\\t";
        else if (character.code != '\n' && is_hidden(character.code))
            out += fmt::format("\\u{:04x}", character.code);
        else
            out += text.substr(0, character.bytes);
        text.remove_prefix(character.bytes);
    }
    return out;
}

}  // namespace

std::string visible(std::string_view text) {
    return shown(text, false);
}

std::string visible_lines(std::string_view text) {
    return shown(text, true);
}

}  // namespace railpem::recordings
