#include "program_run.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace railpem::tests {

namespace fs = std::filesystem;

namespace {

std::string text_of(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

/// In the child: never returns.
void become_program(const fs::path& folder, const std::vector<std::string>& arguments, std::size_t largest_file,
                    const fs::path& output, const fs::path& message) {
    std::vector<char*> words;
    std::string program = RAILPEM_PROGRAM;
    words.push_back(program.data());
    for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
    words.push_back(nullptr);
    const int out = ::open(output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
    const int err = ::open(message.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
    if (out < 0 || err < 0 || ::dup2(out, STDOUT_FILENO) < 0 || ::dup2(err, STDERR_FILENO) < 0 ||
        ::chdir(folder.c_str()) != 0)
        ::_exit(127);
    const rlimit limit{largest_file, largest_file};
    if (largest_file > 0 && ::setrlimit(RLIMIT_FSIZE, &limit) != 0) ::_exit(127);
    ::execv(words.front(), words.data());
    ::_exit(127);
}

}  // namespace

ProgramFolder::ProgramFolder() {
    std::string name = (fs::temp_directory_path() / "railpem-test-XXXXXX").string();
    if (!::mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
    folder_ = name;
}

ProgramFolder::~ProgramFolder() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
    fs::remove(folder_.string() + ".out", ignored);
    fs::remove(folder_.string() + ".err", ignored);
}

void ProgramFolder::write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
}

std::string ProgramFolder::read(const std::string& name) const {
    return text_of(folder_ / name);
}

std::vector<std::string> ProgramFolder::content() const {
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder_))
        names.push_back(fs::relative(entry.path(), folder_).string());
    std::sort(names.begin(), names.end());
    return names;
}

Outcome ProgramFolder::run(const std::vector<std::string>& arguments, std::size_t largest_file,
                           const std::string& output) const {
    const fs::path out = output.empty() ? fs::path(folder_.string() + ".out") : fs::path(output);
    const fs::path err = folder_.string() + ".err";
    const pid_t child = ::fork();
    if (child < 0) throw std::runtime_error("cannot fork");
    if (child == 0) become_program(folder_, arguments, largest_file, out, err);
    int status = 0;
    ::waitpid(child, &status, 0);
    Outcome outcome{
        .status = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status), .output = "", .message = text_of(err)};
    if (output.empty()) outcome.output = text_of(out);
    return outcome;
}

std::string minimal_case(const std::string& from, const std::string& to) {
    std::string text = text_of(fs::path(RAILPEM_SOURCE_DIR) / "tests/input_errors/cases/minimal.toml");
    if (from.empty()) return text;
    const std::size_t at = text.find(from);
    if (at == std::string::npos) throw std::runtime_error("minimal.toml has no '" + from + "'");
    return text.replace(at, from.size(), to);
}

void expect_refused(const std::string& text, const std::string& message, const std::vector<std::string>& options) {
    const ProgramFolder folder;
    folder.write("case.toml", text);
    std::vector<std::string> arguments{"solve", "case.toml", "--out", "new/results"};
    for (const std::string& option : options) arguments.insert(arguments.end(), {"--set", option});
    const Outcome outcome = folder.run(arguments);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.message, message + "\n");
    EXPECT_EQ(outcome.output, "");
    EXPECT_EQ(folder.content(), std::vector<std::string>{"case.toml"});
}

}  // namespace railpem::tests
