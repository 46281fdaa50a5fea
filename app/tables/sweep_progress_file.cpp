#include "app/tables/sweep_progress_file.hpp"

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

Header header_of(std::uint64_t fingerprint, std::size_t rows) {
    Header header{{}, fingerprint, rows};
    std::memcpy(header.magic, kMagic, sizeof kMagic);
    return header;
}

constexpr std::size_t kMostParts = 65535;

/// True for "pads.unfinished" and "pads.unfinished.12" when asked for "pads.unfinished".
bool is_part(const std::string& name, const std::string& first) {
    if (!name.starts_with(first)) return false;
    const std::string rest = name.substr(first.size());
    return rest.empty() ||
           (rest.size() > 1 && rest[0] == '.' && rest.find_first_not_of("0123456789", 1) == std::string::npos);
}

}  // namespace

SweepProgressFile::SweepProgressFile(std::filesystem::path path, const std::string& identity, std::size_t cases,
                                     std::size_t rows, int rank)
    : path_(std::move(path)), fingerprint_(fingerprint(identity)), rows_(rows), holder_(cases, 0) {
    open_own(rank == 0 ? path_ : std::filesystem::path(fmt::format("{}.{}", path_.string(), rank)));
    read_marks(0);
    open_others();
    finished_at_start_ = static_cast<std::size_t>(
        std::count_if(holder_.begin(), holder_.end(), [](std::uint16_t holder) { return holder != 0; }));
}

SweepProgressFile::~SweepProgressFile() {
    for (const Part& part : parts_) close(part.file);
}

void SweepProgressFile::refuse_other_sweep(const std::filesystem::path& path) const {
    throw InputError(fmt::format(
        "{}: holds the unfinished results of another sweep (or of another version of the case or the program)\n"
        "allowed: the sweep that it belongs to; another --out; or delete the file",
        path.string()));
}

void SweepProgressFile::open_own(const std::filesystem::path& path) {
    const int file = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (file < 0)
        throw InputError(fmt::format("{}: cannot be opened: {}\nallowed: a folder that can be written", path.string(),
                                     std::strerror(errno)));
    parts_.push_back({path, file});
    const Header expected = header_of(fingerprint_, rows_);
    Header found{};
    // new, or killed before the header was out: nothing lost
    if (pread(file, &found, sizeof found, 0) < static_cast<ssize_t>(sizeof found)) {
        if (pwrite(file, &expected, sizeof expected, 0) != static_cast<ssize_t>(sizeof expected))
            throw OutputError(fmt::format("{}: {}", path.string(), std::strerror(errno)));
        return;
    }
    if (std::memcmp(&found, &expected, sizeof found) != 0) refuse_other_sweep(path);
}

void SweepProgressFile::open_others() {
    const Header expected = header_of(fingerprint_, rows_);
    std::vector<std::filesystem::path> others;
    const std::filesystem::path folder = path_.has_parent_path() ? path_.parent_path() : std::filesystem::path(".");
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (is_part(entry.path().filename().string(), path_.filename().string()) &&
            entry.path().filename() != parts_.front().path.filename())
            others.push_back(entry.path());
    std::sort(others.begin(), others.end());
    for (const std::filesystem::path& path : others) {
        if (parts_.size() == kMostParts) break;
        const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
        if (file < 0)
            throw InputError(fmt::format("{}: cannot be opened: {}\nallowed: a file that can be read, or delete it",
                                         path.string(), std::strerror(errno)));
        parts_.push_back({path, file});
        Header found{};
        if (pread(file, &found, sizeof found, 0) < static_cast<ssize_t>(sizeof found)) continue;
        if (std::memcmp(&found, &expected, sizeof found) != 0) refuse_other_sweep(path);
        read_marks(parts_.size() - 1);
    }
}

void SweepProgressFile::read_marks(std::size_t part) {
    for (std::size_t index = 0; index < holder_.size(); ++index) {
        double mark = 0.0;
        const off_t place = static_cast<off_t>(sizeof(Header) + ((index + 1) * (rows_ + 1) - 1) * sizeof(double));
        // nothing lies behind the end
        if (pread(parts_[part].file, &mark, sizeof mark, place) != static_cast<ssize_t>(sizeof mark)) return;
        if (mark == static_cast<double>(index + 1)) holder_[index] = static_cast<std::uint16_t>(part + 1);
    }
}

void SweepProgressFile::write(std::size_t index, const std::vector<double>& values) {
    std::vector<double> record = values;
    record.push_back(static_cast<double>(index + 1));
    const std::size_t bytes = record.size() * sizeof(double);
    if (pwrite(parts_.front().file, record.data(), bytes, static_cast<off_t>(sizeof(Header) + index * bytes)) !=
        static_cast<ssize_t>(bytes))
        throw OutputError(fmt::format("{}: {}; finished cases are kept, the same command goes on from there",
                                      parts_.front().path.string(), std::strerror(errno)));
    holder_[index] = 1;
}

void SweepProgressFile::flush() const {
    if (fsync(parts_.front().file) != 0 && errno != EINVAL)  // EINVAL: no disk behind it
        throw OutputError(fmt::format("{}: {}; finished cases are kept, the same command goes on from there",
                                      parts_.front().path.string(), std::strerror(errno)));
}

void SweepProgressFile::gather() {
    for (std::size_t part = 1; part < parts_.size(); ++part) close(parts_[part].file);
    parts_.resize(1);
    open_others();
}

std::vector<double> SweepProgressFile::read(std::size_t first, std::size_t count) const {
    std::vector<double> records(count * rows_);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t index = first + i, bytes = rows_ * sizeof(double);
        const off_t place = static_cast<off_t>(sizeof(Header) + index * (rows_ + 1) * sizeof(double));
        if (holder_[index] == 0 || pread(parts_[holder_[index] - 1u].file, records.data() + i * rows_, bytes, place) !=
                                       static_cast<ssize_t>(bytes))
            throw OutputError(fmt::format("{}: case {} cannot be read back; the same command computes what is missing",
                                          path_.string(), index + 1));
    }
    return records;
}

void SweepProgressFile::remove() {
    std::error_code ignored;
    for (const Part& part : parts_) {
        close(part.file);
        std::filesystem::remove(part.path, ignored);
    }
    parts_.clear();
}

}  // namespace railpem::app
