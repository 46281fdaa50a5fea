#include "app/sweep_progress_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "app/fingerprint.hpp"
#include "app/input_error.hpp"
#include "app/output_folder.hpp"

namespace railpem::app {

namespace {

constexpr char kMagic[8] = {'r', 'a', 'i', 'l', 'p', 's', 'w', '2'};

struct Header {
    char magic[8];
    std::uint64_t fingerprint;
    std::uint64_t rows;
};

}  // namespace

SweepProgressFile::SweepProgressFile(std::filesystem::path path, const std::string& identity, std::size_t cases, std::size_t rows)
    : path_(std::move(path)), rows_(rows), finished_(cases, 0) {
    file_ = open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (file_ < 0)
        throw InputError(fmt::format("{}: cannot be opened: {}\nallowed: a folder that can be written", path_.string(), std::strerror(errno)));
    Header expected{{}, fingerprint(identity), rows}, found{};
    std::memcpy(expected.magic, kMagic, sizeof kMagic);
    const ssize_t size = pread(file_, &found, sizeof found, 0);
    if (size < static_cast<ssize_t>(sizeof found)) {  // new, or killed before the header was out: nothing lost
        if (pwrite(file_, &expected, sizeof expected, 0) != static_cast<ssize_t>(sizeof expected))
            throw OutputError(fmt::format("{}: {}", path_.string(), std::strerror(errno)));
        return;
    }
    if (std::memcmp(&found, &expected, sizeof found) != 0)
        throw InputError(fmt::format("{}: holds the unfinished results of another sweep (or of another version of the case or the program)\n"
                                     "allowed: the sweep that it belongs to; another --out; or delete the file", path_.string()));
    read_marks();
}

SweepProgressFile::~SweepProgressFile() {
    if (file_ >= 0) close(file_);
}

void SweepProgressFile::read_marks() {
    for (std::size_t index = 0; index < finished_.size(); ++index) {
        double mark = 0.0;
        const off_t place = static_cast<off_t>(sizeof(Header) + ((index + 1) * (rows_ + 1) - 1) * sizeof(double));
        if (pread(file_, &mark, sizeof mark, place) == static_cast<ssize_t>(sizeof mark) && mark == static_cast<double>(index + 1)) {
            finished_[index] = 1;
            ++finished_at_start_;
        }
    }
}

void SweepProgressFile::write(std::size_t index, const std::vector<double>& values) {
    std::vector<double> record = values;
    record.push_back(static_cast<double>(index + 1));
    const std::size_t bytes = record.size() * sizeof(double);
    if (pwrite(file_, record.data(), bytes, static_cast<off_t>(sizeof(Header) + index * bytes)) != static_cast<ssize_t>(bytes))
        throw OutputError(fmt::format("{}: {}; finished cases are kept, the same command goes on from there", path_.string(), std::strerror(errno)));
    finished_[index] = 1;
}

std::vector<double> SweepProgressFile::read(std::size_t first, std::size_t count) const {
    std::vector<double> records(count * (rows_ + 1));
    const std::size_t bytes = records.size() * sizeof(double);
    if (pread(file_, records.data(), bytes, static_cast<off_t>(sizeof(Header) + first * (rows_ + 1) * sizeof(double))) != static_cast<ssize_t>(bytes))
        throw OutputError(fmt::format("{}: cannot be read back", path_.string()));
    for (std::size_t i = 0; i < count; ++i) std::copy_n(records.begin() + static_cast<long>(i * (rows_ + 1)), rows_, records.begin() + static_cast<long>(i * rows_));
    records.resize(count * rows_);
    return records;
}

void SweepProgressFile::remove() {
    close(file_);
    file_ = -1;
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
}

}  // namespace railpem::app
