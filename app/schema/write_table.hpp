#pragma once

#include <string>

#include "app/schema/schema.hpp"

namespace railpem::app {

/// The TOML text of a struct: every required value, and the others where they differ from the default. Numbers are
/// written with as many digits as reading them back exactly takes.
std::string write_table(const TableSchema& schema, const void* owner, const void* defaults);

}  // namespace railpem::app
