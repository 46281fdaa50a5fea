#pragma once
// The program called as a function in a folder of its own, for tests of what it writes.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "app/verbs/command_line.hpp"

namespace railpem::app {

struct ProgramResult {
    int status = -1;
    std::string message;  ///< standard error
};

class Scratch {
  public:
    Scratch() {
        std::string name = (std::filesystem::temp_directory_path() / "railpem_app_XXXXXX").string();
        folder_ = mkdtemp(name.data());
    }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
    ~Scratch() {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }
    std::string path(const std::string& name) const { return (folder_ / name).string(); }
    bool has(const std::string& name) const { return std::filesystem::exists(folder_ / name); }
    void write(const std::string& name, const std::string& text) const { std::ofstream(folder_ / name) << text; }
    std::string read(const std::string& name) const {
        std::ifstream file(folder_ / name);
        std::stringstream text;
        text << file.rdbuf();
        return text.str();
    }

  private:
    std::filesystem::path folder_;
};

inline ProgramResult run(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "railpem");
    std::vector<const char*> argv;
    for (const std::string& argument : arguments) argv.push_back(argument.c_str());
    ::testing::internal::CaptureStderr();
    ProgramResult result;
    result.status = run_program(static_cast<int>(argv.size()), argv.data());
    result.message = ::testing::internal::GetCapturedStderr();
    return result;
}

/// A CSV of numbers as columns by name.
inline std::map<std::string, std::vector<double>> columns(const std::string& csv) {
    std::istringstream text(csv);
    std::string line, field;
    std::getline(text, line);
    std::vector<std::string> names;
    for (std::istringstream header(line); std::getline(header, field, ',');) names.push_back(field);
    std::map<std::string, std::vector<double>> table;
    for (const std::string& name : names) table[name];
    while (std::getline(text, line) && !line.starts_with('#')) {
        std::istringstream row(line);
        for (const std::string& name : names) {
            std::getline(row, field, ',');
            table[name].push_back(std::stod(field));
        }
    }
    return table;
}

inline std::string shipped(const std::string& name) {
    return std::string(RAILPEM_SOURCE_DIR) + "/cases/" + name;
}

}  // namespace railpem::app
