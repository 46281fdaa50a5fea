#pragma once
// The schema of the case file, and the page that describes it.

#include <string>

#include "app/schema/schema.hpp"
#include "pem/case_parameters.hpp"

namespace railpem::app {

/// Bound to pem::CaseParameters.
const TableSchema& case_schema();

/// What a file leaves out: as the struct has it, but for the frequency lines, which the program chooses then.
pem::CaseParameters case_defaults();

/// The reference page of the case file.
std::string describe_case();

}  // namespace railpem::app
