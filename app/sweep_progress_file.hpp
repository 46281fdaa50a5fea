#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

namespace railpem::app {

/// The results of a sweep while it runs: one record of fixed length per case, in order, so that whatever ended the run, every
/// whole record is a finished case. A header ties the file to the sweep that made it.
class SweepProgressFile {
  public:
    /// Opens or makes the file. `identity`: a text that is the same only for the same sweep of the same program; `record`: numbers per
    /// case. What follows the last whole record is cut off. Throws InputError when the file belongs to another sweep or cannot be
    /// opened.
    SweepProgressFile(std::filesystem::path path, const std::string& identity, std::size_t record);
    ~SweepProgressFile();
    SweepProgressFile(const SweepProgressFile&) = delete;
    SweepProgressFile& operator=(const SweepProgressFile&) = delete;

    std::size_t finished() const { return finished_; }  ///< cases in the file
    /// Adds whole records. Throws OutputError when they do not reach the disk.
    void append(const std::vector<double>& records);
    /// Reads records first … first + count − 1.
    std::vector<double> read(std::size_t first, std::size_t count);
    /// Closes and deletes the file: the table is written.
    void remove();

  private:
    std::filesystem::path path_;
    std::FILE* file_ = nullptr;
    std::size_t record_;
    std::size_t finished_ = 0;
};

}  // namespace railpem::app
