#pragma once

#include <string>

#include "app/schema/schema.hpp"

namespace railpem::app {

/// The reference page of a file, in Markdown: every table and every key with unit, type, default, range, tolerance,
/// what it is and where its number comes from. `defaults`: a default-constructed struct of the schema.
std::string describe_table(const std::string& title, const std::string& introduction, const TableSchema& schema,
                           const void* defaults);

}  // namespace railpem::app
