#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "app/provenance.hpp"

namespace railpem::app {

/// A result could not be written (a full disk, a lost mount): exit status 1.
class OutputError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// What a run may write over.
enum class Overwrite {
    anything,     ///< whatever is there: for callers who name the file themselves
    own_results,  ///< files that this program wrote (they say so), and no file that this process has read
    not_inputs    ///< anything but files that this process has read: --force
};

/// How a folder writes: over what, and what every text says of where it comes from; asked for when the first is
/// written.
struct Writing {
    Overwrite overwrite = Overwrite::anything;
    std::function<Provenance()> provenance = nullptr;  ///< without it texts are written as they are
};

/// As a verb of the command line writes; `force`: its option --force.
Writing results_of_run(bool force);

/// A folder that receives all files of a run or none. Files are written beside their final names and renamed together
/// by commit(); without it the destructor removes what was written, and the folders that were made for it. Files beside
/// their names bear a name that no other run draws; those of runs that were killed are removed by the next one there.
class OutputFolder {
  public:
    /// Makes the folder where it does not exist and makes sure that files can be made in it.
    /// Throws InputError, naming `option`, when that is not possible.
    explicit OutputFolder(const std::filesystem::path& folder, const std::string& option = "--out",
                          Writing writing = {});
    OutputFolder(const OutputFolder&) = delete;
    OutputFolder& operator=(const OutputFolder&) = delete;
    ~OutputFolder();

    /// Throws InputError where a file of that name is there and may not be written over. write() and write_by() ask,
    /// too; a long run asks before it begins.
    void claim(const std::string& name) const;

    /// Writes a text under a temporary name, with its provenance (stamped()). Throws OutputError when not all of it
    /// reaches the disk.
    void write(const std::string& name, const std::string& content);

    /// Writes a file that is too large for one text, or that a library writes: `writer` makes the file of that path, or
    /// throws OutputError. Throws OutputError when not all of it reaches the disk.
    void write_by(const std::string& name, const std::function<void(const std::filesystem::path&)>& writer);

    /// Gives every file written its name. Throws OutputError.
    void commit();

    const std::filesystem::path& path() const { return folder_; }

    /// What texts of this folder say of where they come from, for files that stamp themselves; nothing without one.
    const Provenance* provenance();

  private:
    struct File {
        std::filesystem::path temporary;
        std::filesystem::path final_name;
    };
    const File& add_file(const std::string& name);
    void make_folders();
    void hold_lock();
    void let_go() noexcept;
    void remove_stale() const noexcept;
    void remove_folders() noexcept;
    void remove_all() noexcept;
    void leave() noexcept;  ///< the list of remove_unfinished_output()
    friend void remove_unfinished_output() noexcept;

    OutputFolder* outer_;  ///< the one that this thread had before
    std::filesystem::path folder_;
    std::string option_;
    Writing writing_;
    std::optional<Provenance> provenance_;
    std::string unique_;          ///< in the names of its files until commit()
    std::filesystem::path lock_;  ///< held while it lives: tells its files from those of a run that was killed
    int lock_descriptor_ = -1;
    std::vector<std::filesystem::path> made_;  ///< folders made here, outermost first
    std::vector<File> files_;
};

/// What the folders of this thread would remove in their destructors, for a program that ends without any. Asks for no
/// memory.
void remove_unfinished_output() noexcept;

}  // namespace railpem::app
