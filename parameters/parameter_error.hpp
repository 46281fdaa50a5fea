#pragma once

#include <stdexcept>
#include <string>

namespace railpem::parameters {

/// Physics that cannot be: thrown by the rules that live with the physics. The reader of the input adds file and line.
class ParameterError : public std::invalid_argument {
  public:
    /// `key`: dotted path as in the case file; `problem`: what is wrong; `allowed`: what would be right.
    ParameterError(std::string key, std::string problem, std::string allowed)
        : std::invalid_argument(key + ": " + problem + "; allowed: " + allowed),
          key_(std::move(key)),
          problem_(std::move(problem)),
          allowed_(std::move(allowed)) {}

    const std::string& key() const { return key_; }
    const std::string& problem() const { return problem_; }
    const std::string& allowed() const { return allowed_; }

  private:
    std::string key_, problem_, allowed_;
};

}  // namespace railpem::parameters
