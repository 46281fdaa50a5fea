#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

namespace railpem::recordings {

/// A file that cannot be read as what it claims to be. The user's error: refused with file, line, problem and remedy.
class ReadError : public std::runtime_error {
  public:
    /// `line`: counted from 1; 0 when the problem has no line (binary files, the file as a whole).
    ReadError(std::string file, std::size_t line, std::string problem, std::string allowed);

    const std::string& file() const { return file_; }
    std::size_t line() const { return line_; }
    const std::string& problem() const { return problem_; }
    const std::string& allowed() const { return allowed_; }

  private:
    std::string file_;
    std::size_t line_;
    std::string problem_, allowed_;
};

}  // namespace railpem::recordings
