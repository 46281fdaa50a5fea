#pragma once

#include <string>

#include "app/schema/document.hpp"
#include "app/schema/schema.hpp"

namespace railpem::app {

/// Applies `--set key=value` to the tree of a file: replaces the value, or adds it together with the tables around it.
/// A list of tables is addressed by element, counted from 1; the number may be left out when there is one element or
/// none. Throws InputError.
void apply_option(Document& document, const TableSchema& schema, const std::string& key_and_value);

}  // namespace railpem::app
