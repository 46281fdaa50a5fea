#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace railpem::app {

/// The results of a sweep while it runs: one record of fixed length per case at its own place, closed by a mark, so that whatever ended
/// the run, every marked record is a finished case and none is lost. A header ties the file to the sweep that made it.
class SweepProgressFile {
  public:
    /// Opens or makes the file. `identity`: a text that is the same only for the same sweep of the same program; `cases` records of
    /// `rows` numbers. Throws InputError when the file belongs to another sweep or cannot be opened.
    SweepProgressFile(std::filesystem::path path, const std::string& identity, std::size_t cases, std::size_t rows);
    ~SweepProgressFile();
    SweepProgressFile(const SweepProgressFile&) = delete;
    SweepProgressFile& operator=(const SweepProgressFile&) = delete;

    bool finished(std::size_t index) const { return finished_[index] != 0; }
    std::size_t finished_at_start() const { return finished_at_start_; }
    /// Puts the record of a case on file; from any thread. Throws OutputError when it does not get there.
    void write(std::size_t index, const std::vector<double>& values);
    /// Reads the records first … first + count − 1, without their marks.
    std::vector<double> read(std::size_t first, std::size_t count) const;
    /// Closes and deletes the file: the table is written.
    void remove();

  private:
    void read_marks();

    std::filesystem::path path_;
    int file_ = -1;
    std::size_t rows_;
    std::vector<char> finished_;
    std::size_t finished_at_start_ = 0;
};

}  // namespace railpem::app
