#include "app/sweep_progress_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>

#include "app/input_error.hpp"
#include "app/output_folder.hpp"

namespace railpem::app {

namespace {

constexpr char kMagic[8] = {'r', 'a', 'i', 'l', 'p', 's', 'w', '1'};
constexpr std::size_t kHeader = sizeof kMagic + 2 * sizeof(std::uint64_t);

/// FNV-1a, 64 bits: tells sweeps apart, no defence against malice.
std::uint64_t fingerprint(const std::string& text) {
    std::uint64_t hash = 0xcbf29ce484222325ULL;
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
    return hash;
}

}  // namespace

SweepProgressFile::SweepProgressFile(std::filesystem::path path, const std::string& identity, std::size_t record)
    : path_(std::move(path)), record_(record) {
    const std::uint64_t header[2] = {fingerprint(identity), record};
    std::error_code ignored;
    const std::uintmax_t size = std::filesystem::exists(path_) ? std::filesystem::file_size(path_, ignored) : 0;
    const bool fresh = size < kHeader;  // killed before the header was out: nothing lost
    file_ = std::fopen(path_.c_str(), fresh ? "w+b" : "r+b");
    if (!file_) throw InputError(fmt::format("{}: cannot be opened: {}\nallowed: a folder that can be written", path_.string(), std::strerror(errno)));
    if (fresh) {
        if (std::fwrite(kMagic, sizeof kMagic, 1, file_) != 1 || std::fwrite(header, sizeof header, 1, file_) != 1 || std::fflush(file_) != 0)
            throw OutputError(fmt::format("{}: {}", path_.string(), std::strerror(errno)));
        return;
    }
    char magic[sizeof kMagic];
    std::uint64_t found[2];
    if (std::fread(magic, sizeof magic, 1, file_) != 1 || std::fread(found, sizeof found, 1, file_) != 1 ||
        std::memcmp(magic, kMagic, sizeof magic) != 0 || found[0] != header[0] || found[1] != header[1])
        throw InputError(fmt::format("{}: holds the unfinished results of another sweep (or of another version of the case or the program)\n"
                                     "allowed: the sweep that it belongs to; another --out; or delete the file", path_.string()));
    finished_ = (size - kHeader) / (record_ * sizeof(double));
    std::filesystem::resize_file(path_, kHeader + finished_ * record_ * sizeof(double));
    std::fseek(file_, 0, SEEK_END);
}

SweepProgressFile::~SweepProgressFile() {
    if (file_) std::fclose(file_);
}

void SweepProgressFile::append(const std::vector<double>& records) {
    std::fseek(file_, 0, SEEK_END);
    if (std::fwrite(records.data(), sizeof(double), records.size(), file_) != records.size() || std::fflush(file_) != 0)
        throw OutputError(fmt::format("{}: {}; {} finished cases are kept, the same command goes on from there", path_.string(), std::strerror(errno), finished_));
    finished_ += records.size() / record_;
}

std::vector<double> SweepProgressFile::read(std::size_t first, std::size_t count) {
    std::vector<double> records(count * record_);
    std::fseek(file_, static_cast<long>(kHeader + first * record_ * sizeof(double)), SEEK_SET);
    if (std::fread(records.data(), sizeof(double), records.size(), file_) != records.size())
        throw OutputError(fmt::format("{}: cannot be read back", path_.string()));
    return records;
}

void SweepProgressFile::remove() {
    std::fclose(file_);
    file_ = nullptr;
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
}

}  // namespace railpem::app
