#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace railpem::app {

/// The results of a sweep while it runs: one record of fixed length per case at its own place, closed by a mark, so
/// that whatever ended the run, every marked record is a finished case and none is lost. A header ties the file to the
/// sweep that made it. Processes that share a sweep write a file each, `path`, `path.1`, `path.2` …: what one of them
/// has finished no other can damage, on any file system. All that are there count, whoever wrote them, so a sweep goes
/// on with more processes, fewer, or one.
class SweepProgressFile {
  public:
    /// Opens or makes the file of process `rank` and reads what all files hold. `identity`: a text that is the same
    /// only for the same sweep of the same program; `cases` records of `rows` numbers. Throws InputError when a file
    /// belongs to another sweep or cannot be opened.
    SweepProgressFile(std::filesystem::path path, const std::string& identity, std::size_t cases, std::size_t rows,
                      int rank = 0);
    ~SweepProgressFile();
    SweepProgressFile(const SweepProgressFile&) = delete;
    SweepProgressFile& operator=(const SweepProgressFile&) = delete;

    bool finished(std::size_t index) const { return holder_[index] != 0; }
    std::size_t finished_at_start() const { return finished_at_start_; }
    /// Puts the record of a case on file; from any thread. Throws OutputError when it does not get there.
    void write(std::size_t index, const std::vector<double>& values);
    /// Hands what was written to the disk, for the process that gathers.
    void flush() const;
    /// Looks again at all files: when every process has flushed, all cases are finished.
    void gather();
    /// Reads the records first … first + count − 1, without their marks.
    std::vector<double> read(std::size_t first, std::size_t count) const;
    /// Closes and deletes all files: the table is written.
    void remove();

  private:
    struct Part {
        std::filesystem::path path;
        int file = -1;
    };
    void open_own(const std::filesystem::path& path);
    void open_others();
    void read_marks(std::size_t part);
    [[noreturn]] void refuse_other_sweep(const std::filesystem::path& path) const;

    std::filesystem::path path_;
    std::uint64_t fingerprint_;
    std::size_t rows_;
    std::vector<Part> parts_;            ///< the own one first
    std::vector<std::uint16_t> holder_;  ///< per case: part that holds it, from 1; 0: unfinished
    std::size_t finished_at_start_ = 0;
};

}  // namespace railpem::app
