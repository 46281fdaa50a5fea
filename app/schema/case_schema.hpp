#pragma once
// The schema of the case file, and the page that describes it.

#include <string>

#include "app/schema/schema.hpp"

namespace railpem::app {

/// Bound to pem::CaseParameters.
const TableSchema& case_schema();

/// The reference page of the case file.
std::string describe_case();

}  // namespace railpem::app
