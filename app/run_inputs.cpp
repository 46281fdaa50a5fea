#include "app/run_inputs.hpp"

#include <algorithm>
#include <mutex>

namespace railpem::app {

namespace {

std::mutex noting;

std::vector<std::filesystem::path>& noted() {
    static std::vector<std::filesystem::path> files;
    return files;
}

}  // namespace

void note_input(const std::filesystem::path& file) {
    std::error_code status;
    if (file.empty() || std::filesystem::is_directory(file, status) || !std::filesystem::exists(file, status)) return;
    const std::lock_guard lock(noting);
    if (std::find(noted().begin(), noted().end(), file) == noted().end()) noted().push_back(file);
}

std::vector<std::filesystem::path> noted_inputs() {
    const std::lock_guard lock(noting);
    return noted();
}

}  // namespace railpem::app
