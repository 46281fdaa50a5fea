#include "app/output_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <random>
#include <string_view>
#include <system_error>

#include "app/input_error.hpp"
#include "app/program_version.hpp"
#include "app/run_inputs.hpp"

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

constexpr const char* kLockBegins = ".railpem-";
constexpr const char* kPartial = ".partial";

/// Sixteen digits that no other run draws: processes of different containers have equal numbers.
std::string unique_text() {
    std::random_device device;
    return fmt::format("{:08x}{:08x}", device(), device());
}

/// Whether a file says that this program wrote it, near its beginning or its end: a stamp of provenance.
bool is_own_result(const fs::path& file) {
    constexpr std::streamoff kLooked = 1 << 16;
    std::ifstream in(file, std::ios::binary);
    std::string text(static_cast<std::size_t>(kLooked), '\0');
    const auto look = [&] {
        in.read(text.data(), kLooked);
        return std::string_view(text.data(), static_cast<std::size_t>(in.gcount())).find(kProgramStamp) !=
               std::string_view::npos;
    };
    if (!in) return false;
    if (look()) return true;
    std::error_code status;
    const auto size = static_cast<std::streamoff>(fs::file_size(file, status));
    in.clear();
    in.seekg(std::max<std::streamoff>(0, size - kLooked));
    if (look()) return true;
    return size == 0;  // nothing is lost
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

Writing results_of_run(bool force) {
    return {force ? Overwrite::not_inputs : Overwrite::own_results, run_provenance};
}

OutputFolder::OutputFolder(const fs::path& folder, const std::string& option, Writing writing)
    : outer_(innermost),
      folder_(folder.empty() ? fs::path(".") : folder),
      option_(option),
      writing_(std::move(writing)),
      unique_(unique_text()) {
    if (folder.empty() && option_ == kFolderOption)
        throw InputError(fmt::format(
            "{}: no folder is named\nallowed: a folder that can be written, or a new one; . is the current one",
            option_));
    innermost = this;
    try {
        make_folders();
        hold_lock();
        remove_stale();
    } catch (...) {  // for want of memory, too: a folder that is not made yet has no destructor
        let_go();
        remove_folders();
        leave();
        throw;
    }
}

OutputFolder::~OutputFolder() {
    remove_all();
    leave();
}

void OutputFolder::hold_lock() {
    lock_ = folder_ / fmt::format("{}{}{}", kLockBegins, unique_, kPartial);
    lock_descriptor_ = ::open(lock_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (lock_descriptor_ < 0) refuse_folder(option_, folder_, std::strerror(errno));
    ::flock(lock_descriptor_, LOCK_EX | LOCK_NB);  // where a file system knows no locks nothing is cleaned either
}

void OutputFolder::let_go() noexcept {
    if (lock_descriptor_ < 0) return;
    std::error_code ignored;
    fs::remove(lock_, ignored);
    ::close(lock_descriptor_);
    lock_descriptor_ = -1;
}

void OutputFolder::remove_stale() const noexcept try {
    std::vector<std::string> dead;
    std::error_code ignored;
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_, ignored)) files.push_back(entry.path());
    for (const fs::path& file : files) {
        const std::string name = file.filename().string();
        if (!name.starts_with(kLockBegins) || !name.ends_with(kPartial) || file == lock_) continue;
        const int descriptor = ::open(file.c_str(), O_WRONLY | O_CLOEXEC | O_NOFOLLOW);
        if (descriptor < 0) continue;
        if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0)  // nobody holds it: who made it has ended
            dead.push_back(name.substr(std::strlen(kLockBegins)));
        ::close(descriptor);
    }
    for (const fs::path& file : files)
        for (const std::string& ending : dead) {
            const std::string name = file.filename().string();
            const bool own = name.starts_with(".") && name.ends_with("." + ending);
            if (own || name == kLockBegins + ending) fs::remove(file, ignored);
        }
} catch (...) {  // what cannot be cleaned stays
}

void OutputFolder::claim(const std::string& name) const {
    const fs::path file = folder_ / name;
    std::error_code status;
    if (writing_.overwrite == Overwrite::anything || !fs::exists(file, status)) return;
    for (const fs::path& input : noted_inputs())
        if (fs::equivalent(input, file, status))
            throw InputError(
                fmt::format("{} {}: {} is an input of this run and would be written over\n"
                            "allowed: another folder or name",
                            option_, folder_.string(), file.string()));
    if (writing_.overwrite == Overwrite::not_inputs || !fs::is_regular_file(file, status) || is_own_result(file))
        return;
    throw InputError(
        fmt::format("{} {}: {} is there, and nothing in it says that railpem wrote it\n"
                    "allowed: another folder or name, or --force to write over it",
                    option_, folder_.string(), file.string()));
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
    claim(name);
    return files_.emplace_back(File{folder_ / fmt::format(".{}.{}{}", name, unique_, kPartial), folder_ / name});
}

void OutputFolder::write(const std::string& name, const std::string& content) {
    const File file = add_file(name);
    const Provenance* from = provenance();
    const int failure = write_file(file.temporary, from ? stamped(name, content, *from) : content);
    if (failure != 0) fail_file(file.final_name, std::strerror(failure), kNothingKept);
}

const Provenance* OutputFolder::provenance() {
    if (!provenance_ && writing_.provenance) provenance_ = writing_.provenance();
    return provenance_ ? &*provenance_ : nullptr;
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
    let_go();
}

void OutputFolder::remove_folders() noexcept {
    std::error_code ignored;
    for (auto made = made_.rbegin(); made != made_.rend(); ++made) fs::remove(*made, ignored);  // only when empty
    made_.clear();
}

void OutputFolder::remove_all() noexcept {
    std::error_code ignored;
    for (const File& file : files_) fs::remove(file.temporary, ignored);
    let_go();
    remove_folders();
}

void remove_unfinished_output() noexcept {
    for (OutputFolder* own = innermost; own; own = own->outer_) own->remove_all();
}

}  // namespace railpem::app
