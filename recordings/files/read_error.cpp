#include "recordings/files/read_error.hpp"

#include <fmt/format.h>

namespace railpem::recordings {
namespace {

std::string message(const std::string& file, std::size_t line, const std::string& problem, const std::string& allowed) {
    return line > 0 ? fmt::format("{}:{}: {}; allowed: {}", file, line, problem, allowed)
                    : fmt::format("{}: {}; allowed: {}", file, problem, allowed);
}

}  // namespace

ReadError::ReadError(std::string file, std::size_t line, std::string problem, std::string allowed)
    : std::runtime_error(message(file, line, problem, allowed)),
      file_(std::move(file)),
      line_(line),
      problem_(std::move(problem)),
      allowed_(std::move(allowed)) {}

}  // namespace railpem::recordings
