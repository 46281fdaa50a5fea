#pragma once
// The real program, run in a folder of its own.

#include <filesystem>
#include <string>
#include <vector>

namespace railpem::tests {

struct Outcome {
    int status = -1;      ///< exit status, or −signal
    std::string output;   ///< standard output
    std::string message;  ///< standard error
};

/// A temporary folder that the program runs in, so that names in its messages are short and the same everywhere.
class ProgramFolder {
  public:
    ProgramFolder();
    ProgramFolder(const ProgramFolder&) = delete;
    ProgramFolder& operator=(const ProgramFolder&) = delete;
    ~ProgramFolder();

    void write(const std::string& name, const std::string& text) const;
    std::string read(const std::string& name) const;
    std::filesystem::path path(const std::string& name) const { return folder_ / name; }
    /// Every file and folder in it, sorted.
    std::vector<std::string> content() const;

    /// Runs railpem with these arguments. `largest_file`: bytes that a file may grow to, 0 for no limit.
    /// `output`: where the standard output goes instead of into the outcome.
    Outcome run(const std::vector<std::string>& arguments, std::size_t largest_file = 0,
                const std::string& output = "") const;

  private:
    std::filesystem::path folder_;
};

/// The valid case of minimal.toml with `from` replaced by `to` (which must be in it).
std::string minimal_case(const std::string& from = "", const std::string& to = "");

/// Solves the text as case.toml and expects this message, and nothing written.
void expect_refused(const std::string& text, const std::string& message, const std::vector<std::string>& options = {});

}  // namespace railpem::tests
