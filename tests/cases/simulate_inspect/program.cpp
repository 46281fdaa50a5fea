#include "program.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace railpem::tests {

namespace fs = std::filesystem;

namespace {

fs::path fresh_folder() {
    std::string name = (fs::temp_directory_path() / "railpem_record_XXXXXX").string();
    if (!::mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
    return name;
}

}  // namespace

std::string text_of(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

Folder::Folder() : path_(fresh_folder()), messages_(fresh_folder()) {}

Folder::~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
    fs::remove_all(messages_, ignored);
}

Outcome Folder::run(const std::vector<std::string>& arguments) const {
    const fs::path out = messages_ / "out", err = messages_ / "err";
    const pid_t child = ::fork();
    if (child < 0) throw std::runtime_error("cannot fork");
    if (child == 0) {
        ::dup2(::open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDOUT_FILENO);
        ::dup2(::open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDERR_FILENO);
        if (::chdir(path_.c_str()) != 0) ::_exit(127);
        std::vector<char*> words{const_cast<char*>(RAILPEM_PROGRAM)};
        for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
        words.push_back(nullptr);
        ::execv(RAILPEM_PROGRAM, words.data());
        ::_exit(127);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return {.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1, .output = text_of(out), .message = text_of(err)};
}

void Folder::write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
}

std::string Folder::read(const std::string& name) const {
    return text_of(path_ / name);
}

std::vector<std::string> Folder::content() const {
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(path_))
        names.push_back(fs::relative(entry.path(), path_).string());
    std::sort(names.begin(), names.end());
    return names;
}

}  // namespace railpem::tests
