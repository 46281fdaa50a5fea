#pragma once
// The verbs of the program. Each one declares its own options and runs; main() knows nothing of them.

#include <functional>

namespace CLI {
class App;
}

namespace railpem::app {

/// What the chosen verb does once its arguments are read; returns the exit status.
using Run = std::function<int()>;

/// What --force means wherever a verb writes files.
inline constexpr const char* kForceSays =
    "write over files that this program did not write; never over an input of the run";

void add_solve(CLI::App& program, Run& run);
void add_sweep(CLI::App& program, Run& run);
void add_static(CLI::App& program, Run& run);
void add_simulate(CLI::App& program, Run& run);
void add_inspect(CLI::App& program, Run& run);
void add_receptance(CLI::App& program, Run& run);
void add_compare(CLI::App& program, Run& run);
void add_validate(CLI::App& program, Run& run);
void add_diagnose(CLI::App& program, Run& run);
void add_prove(CLI::App& program, Run& run);
void add_describe(CLI::App& program, Run& run);

}  // namespace railpem::app
