#pragma once

#include <vector>

#include "app/schema/case_file.hpp"
#include "app/tables/response_tables.hpp"

namespace railpem::app {

/// The case at each of its speeds, with a bar on the terminal. `threads`: 0 for as many as the machine has.
/// Throws InputError at the value of the case that physics refuses.
std::vector<ResponseSpectra> solve_speeds(const CaseFile& file, int threads);

}  // namespace railpem::app
