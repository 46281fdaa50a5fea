#pragma once
// Single values of a case by dotted key, as `--set` addresses them.

#include <optional>
#include <string>
#include <vector>

#include "app/schema/case_file.hpp"
#include "app/schema/case_schema.hpp"

namespace railpem::app {

/// The value of a key as the file and its options state it, before the effects of the case: "vehicle.payload_kg",
/// "irregularity.band[2].exponent". The number of an element may be left out where a list has one. Nothing when the
/// case has no such key.
std::optional<parameters::Value> case_value(const CaseFile& file, const std::string& key);

/// Every key that has a value in this case, elements of lists stated, in the order of the schema.
std::vector<std::string> case_keys(const CaseFile& file);

/// The message for a key that the case does not have, with the nearest one that it has.
InputError unknown_case_key(const CaseFile& file, const std::string& key);

}  // namespace railpem::app
