#pragma once
// What the cases of a sweep were warned of, kept beside their results until the table is written.

#include <filesystem>
#include <mutex>
#include <string>
#include <vector>

namespace railpem::app {

struct SweepWarning {
    std::size_t index = 0;  ///< of the case, from 0
    double speed_m_per_s = 0.0;
    std::string says;
};

/// Files `path`-warnings, -warnings.1 … beside the progress files, one per process; a sweep that goes on finds those of
/// before. A line that was not finished is left out.
class SweepWarnings {
  public:
    SweepWarnings(const std::filesystem::path& path, int rank);

    /// From any thread. What cannot be written is lost: results matter more.
    void add(const SweepWarning& warning);
    /// Those of all processes, by case, each once.
    std::vector<SweepWarning> gather() const;
    /// Deletes the files: the table is written.
    void remove() const;

  private:
    std::vector<std::filesystem::path> files() const;
    std::filesystem::path first_, own_;
    std::mutex writing_;
};

/// The *.warnings.csv table: case (from 1), speed_m_per_s, warning (in quotes).
std::string warnings_csv(const std::vector<SweepWarning>& warnings);

/// For the eye, a line or two: how many cases of `cases` were warned of, and the first warning.
std::string warnings_text(const std::vector<SweepWarning>& warnings, std::size_t cases);

}  // namespace railpem::app
