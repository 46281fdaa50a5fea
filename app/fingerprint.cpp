#include "app/fingerprint.hpp"

#include <fmt/format.h>

namespace railpem::app {

std::uint64_t fingerprint(std::string_view text) {
    std::uint64_t hash = 0xcbf29ce484222325ULL;
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
    return hash;
}

std::string fingerprint_text(std::string_view text) {
    return fmt::format("{:016x}", fingerprint(text));
}

}  // namespace railpem::app
