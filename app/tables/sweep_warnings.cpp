#include "app/tables/sweep_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <set>
#include <tuple>

#include "app/number_table.hpp"
#include "app/output_folder.hpp"

namespace railpem::app {

namespace fs = std::filesystem;

namespace {

auto order_of(const SweepWarning& warning) {
    return std::tie(warning.index, warning.speed_m_per_s, warning.says);
}

bool stands_before(const SweepWarning& a, const SweepWarning& b) {
    return order_of(a) < order_of(b);
}

}  // namespace

SweepWarnings::SweepWarnings(const fs::path& path, int rank)
    : first_(path.string() + "-warnings"),
      own_(rank == 0 ? first_ : fs::path(fmt::format("{}.{}", first_.string(), rank))) {}

void SweepWarnings::add(const SweepWarning& warning) {
    const std::lock_guard lock(writing_);
    std::ofstream out(own_, std::ios::app | std::ios::binary);
    out << fmt::format("{} {} {}\n", warning.index, warning.speed_m_per_s, warning.says);
    out.close();
    if (!out) throw OutputError(fmt::format("{}: {}", own_.string(), std::strerror(errno)));
}

std::vector<fs::path> SweepWarnings::files() const {
    std::vector<fs::path> all;
    std::error_code ignored;
    const fs::path folder = first_.has_parent_path() ? first_.parent_path() : fs::path(".");
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
        const std::string name = entry.path().filename().string(), first = first_.filename().string();
        if (name == first || (name.starts_with(first + ".") &&
                              name.find_first_not_of("0123456789", first.size() + 1) == std::string::npos))
            all.push_back(entry.path());
    }
    return all;
}

std::vector<SweepWarning> SweepWarnings::gather() const {
    std::vector<SweepWarning> all;
    for (const fs::path& file : files()) {
        std::ifstream in(file, std::ios::binary);
        for (SweepWarning own; in >> own.index >> own.speed_m_per_s && in.ignore() && std::getline(in, own.says);)
            if (!in.eof()) all.push_back(own);
    }
    std::sort(all.begin(), all.end(), stands_before);
    all.erase(std::unique(all.begin(), all.end(),
                          [](const SweepWarning& a, const SweepWarning& b) { return order_of(a) == order_of(b); }),
              all.end());
    return all;
}

void SweepWarnings::remove() const {
    std::error_code ignored;
    for (const fs::path& file : files()) fs::remove(file, ignored);
}

std::string warnings_csv(const std::vector<SweepWarning>& warnings) {
    std::string text = "case,speed_m_per_s,warning\n";
    for (const SweepWarning& warning : warnings) {
        std::string says;
        for (const char c : warning.says) says += c == '"' ? std::string("\"\"") : std::string(1, c);
        text += fmt::format("{},{:.{}g},\"{}\"\n", warning.index + 1, warning.speed_m_per_s, kDigits, says);
    }
    return text;
}

std::string warnings_text(const std::vector<SweepWarning>& warnings, std::size_t cases) {
    if (warnings.empty()) return "";
    std::set<std::size_t> warned;
    for (const SweepWarning& warning : warnings) warned.insert(warning.index);
    return fmt::format("warning: {} of {} cases; case {} at {:g} m/s: {}\n", warned.size(), cases,
                       warnings.front().index + 1, warnings.front().speed_m_per_s, warnings.front().says);
}

}  // namespace railpem::app
