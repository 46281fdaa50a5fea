#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace railpem::app::testing {

/// Everything in a file.
inline std::string file_text(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

}  // namespace railpem::app::testing
