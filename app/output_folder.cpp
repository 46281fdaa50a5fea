#include "app/output_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>

#include "app/input_error.hpp"

namespace railpem::app {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void refuse_folder(const std::string& option, const fs::path& folder, const std::string& reason) {
    throw InputError(fmt::format("{} {}: cannot be written: {}\nallowed: a folder that can be written, or a new one",
                                 option, folder.string(), reason));
}

[[noreturn]] void fail_file(const fs::path& file, const std::string& reason, const std::string& consequence) {
    throw OutputError(fmt::format("cannot write {}: {}{}", file.string(), reason, consequence));
}

thread_local OutputFolder* innermost = nullptr;  ///< for remove_unfinished_output()

constexpr const char* kFolderOption = "--out";  ///< others name a file, whose folder may be the current one
constexpr const char* kNothingKept = "\nnothing of this run was kept";

/// Writes and flushes to the disk, so that a full disk is found here and not after the run has said that all is well.
/// Returns 0, or the error number.
int write_file(const fs::path& file, const std::string& content) {
    const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor < 0) return errno;
    int failure = 0;
    for (std::size_t written = 0; written < content.size() && failure == 0;) {
        const ssize_t count = ::write(descriptor, content.data() + written, content.size() - written);
        if (count >= 0)
            written += static_cast<std::size_t>(count);
        else if (errno != EINTR)
            failure = errno;
    }
    if (failure == 0 && ::fsync(descriptor) != 0 && errno != EINVAL) failure = errno;  // EINVAL: no disk behind it
    if (::close(descriptor) != 0 && failure == 0) failure = errno;
    return failure;
}

/// Flushes a file to the disk that somebody else has written. Returns 0, or the error number.
int flush_file(const fs::path& file) {
    const int descriptor = ::open(file.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor < 0) return errno;
    int failure = ::fsync(descriptor) != 0 && errno != EINVAL ? errno : 0;
    if (::close(descriptor) != 0 && failure == 0) failure = errno;
    return failure;
}

}  // namespace

OutputFolder::OutputFolder(const fs::path& folder, const std::string& option)
    : outer_(innermost), folder_(folder.empty() ? fs::path(".") : folder), option_(option) {
    if (folder.empty() && option_ == kFolderOption)
        throw InputError(fmt::format(
            "{}: no folder is named\nallowed: a folder that can be written, or a new one; . is the current one",
            option_));
    innermost = this;
    try {
        make_folders();
        const fs::path probe = folder_ / fmt::format(".railpem-{}.partial", ::getpid());
        const int failure = write_file(probe, "");
        if (failure != 0) refuse_folder(option_, folder_, std::strerror(failure));
        std::error_code ignored;
        fs::remove(probe, ignored);
    } catch (...) {  // for want of memory, too: a folder that is not made yet has no destructor
        remove_folders();
        leave();
        throw;
    }
}

OutputFolder::~OutputFolder() {
    remove_all();
    leave();
}

void OutputFolder::leave() noexcept {
    for (OutputFolder** own = &innermost; *own; own = &(*own)->outer_)  // in whatever order they end
        if (*own == this) return static_cast<void>(*own = outer_);
}

void OutputFolder::make_folders() {
    std::vector<fs::path> missing;
    std::error_code status;
    for (fs::path level = folder_; !level.empty() && !fs::exists(level, status); level = level.parent_path()) {
        missing.push_back(level);
        if (level == level.parent_path()) break;
    }
    for (auto level = missing.rbegin(); level != missing.rend(); ++level) {
        std::error_code failure;
        made_.push_back(*level);  // before it is there, so that none is there that nobody knows of
        if (!fs::create_directory(*level, failure)) made_.pop_back();
        if (failure) refuse_folder(option_, folder_, failure.message());
    }
    if (!fs::is_directory(folder_, status)) refuse_folder(option_, folder_, std::strerror(ENOTDIR));
}

const OutputFolder::File& OutputFolder::add_file(const std::string& name) {
    return files_.emplace_back(File{folder_ / fmt::format(".{}.{}.partial", name, ::getpid()), folder_ / name});
}

void OutputFolder::write(const std::string& name, const std::string& content) {
    const File file = add_file(name);
    const int failure = write_file(file.temporary, content);
    if (failure != 0) fail_file(file.final_name, std::strerror(failure), kNothingKept);
}

void OutputFolder::write_by(const std::string& name, const std::function<void(const fs::path&)>& writer) {
    const File file = add_file(name);
    writer(file.temporary);
    const int failure = flush_file(file.temporary);
    if (failure != 0) fail_file(file.final_name, std::strerror(failure), kNothingKept);
}

void OutputFolder::commit() {
    std::error_code failure;
    for (const File& file : files_)
        if (fs::is_directory(file.final_name, failure))
            fail_file(file.final_name, "a folder of that name is in the way", kNothingKept);
        else if (fs::exists(file.final_name, failure) && !fs::is_regular_file(file.final_name, failure))
            fail_file(file.final_name, "a device or a pipe of that name is in the way", kNothingKept);
    for (const File& file : files_) {
        fs::rename(file.temporary, file.final_name, failure);
        if (failure) fail_file(file.final_name, failure.message(), "");
    }
    files_.clear();
    made_.clear();
}

void OutputFolder::remove_folders() noexcept {
    std::error_code ignored;
    for (auto made = made_.rbegin(); made != made_.rend(); ++made) fs::remove(*made, ignored);  // only when empty
    made_.clear();
}

void OutputFolder::remove_all() noexcept {
    std::error_code ignored;
    for (const File& file : files_) fs::remove(file.temporary, ignored);
    remove_folders();
}

void remove_unfinished_output() noexcept {
    for (OutputFolder* own = innermost; own; own = own->outer_) own->remove_all();
}

}  // namespace railpem::app
