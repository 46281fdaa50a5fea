#pragma once
// The real program, run in a folder of its own that is removed afterwards.

#include <filesystem>
#include <string>
#include <vector>

namespace railpem::tests {

inline const std::string kCase = std::string(RAILPEM_SOURCE_DIR) + "/cases/wei2016/case2.toml";

struct Outcome {
    int status = -1;      ///< exit status; -1: killed
    std::string output;   ///< standard output
    std::string message;  ///< standard error
};

class Folder {
  public:
    Folder();
    ~Folder();
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    Outcome run(const std::vector<std::string>& arguments) const;
    void write(const std::string& name, const std::string& text) const;
    std::string read(const std::string& name) const;
    bool has(const std::string& name) const { return std::filesystem::exists(path_ / name); }
    /// Every file and folder in it, sorted.
    std::vector<std::string> content() const;

  private:
    std::filesystem::path path_, messages_;
};

/// Text of any file; empty when there is none.
std::string text_of(const std::filesystem::path& file);

}  // namespace railpem::tests
