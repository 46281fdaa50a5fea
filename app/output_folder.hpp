#pragma once

#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace railpem::app {

/// A result could not be written (a full disk, a lost mount): exit status 1.
class OutputError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// A folder that receives all files of a run or none. Files are written beside their final names and renamed together
/// by commit(); without it the destructor removes what was written, and the folders that were made for it.
class OutputFolder {
  public:
    /// Makes the folder where it does not exist and makes sure that files can be made in it.
    /// Throws InputError, naming `option`, when that is not possible.
    explicit OutputFolder(const std::filesystem::path& folder, const std::string& option = "--out");
    OutputFolder(const OutputFolder&) = delete;
    OutputFolder& operator=(const OutputFolder&) = delete;
    ~OutputFolder();

    /// Writes a file under a temporary name. Throws OutputError when not all of it reaches the disk.
    void write(const std::string& name, const std::string& content);

    /// Writes a file that is too large for one text, or that a library writes: `writer` makes the file of that path, or
    /// throws OutputError. Throws OutputError when not all of it reaches the disk.
    void write_by(const std::string& name, const std::function<void(const std::filesystem::path&)>& writer);

    /// Gives every file written its name. Throws OutputError.
    void commit();

    const std::filesystem::path& path() const { return folder_; }

  private:
    struct File {
        std::filesystem::path temporary;
        std::filesystem::path final_name;
    };
    const File& add_file(const std::string& name);
    void make_folders();
    void remove_folders() noexcept;
    void remove_all() noexcept;
    void leave() noexcept;  ///< the list of remove_unfinished_output()
    friend void remove_unfinished_output() noexcept;

    OutputFolder* outer_;  ///< the one that this thread had before
    std::filesystem::path folder_;
    std::string option_;
    std::vector<std::filesystem::path> made_;  ///< folders made here, outermost first
    std::vector<File> files_;
};

/// What the folders of this thread would remove in their destructors, for a program that ends without any. Asks for no
/// memory.
void remove_unfinished_output() noexcept;

}  // namespace railpem::app
