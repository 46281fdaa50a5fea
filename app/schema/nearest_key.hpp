#pragma once

#include <string>
#include <vector>

#include "app/input_error.hpp"

namespace railpem::app {

/// Insertions, deletions, replacements and swaps of neighbours that turn one word into the other (optimal string
/// alignment).
std::size_t edit_distance(const std::string& a, const std::string& b);

/// The key without the unit that it ends in: "body_mass_kg" → "body_mass", "speeds_m_per_s" → "speeds".
/// "stem" only when something is left: "m" stays "m".
std::string without_unit(const std::string& key);

/// The known key that was probably meant: the same name with another unit or none, else the one within a third of its
/// length in edits. Empty when none is near.
std::string nearest_key(const std::string& unknown, const std::vector<std::string>& known);

/// The hint of a refusal: "did you mean 'body_mass_kg'?" Empty when no known key is near.
std::string did_you_mean(const std::string& unknown, const std::vector<std::string>& known);

/// Names as a list for messages: "a, b, c".
std::string joined(const std::vector<std::string>& names);

/// The refusal of a name in a command line: "--without: unknown effect 'body-bendin'", what is allowed, and the hint.
InputError unknown_name(const std::string& option, const std::string& what, const std::string& name,
                        const std::vector<std::string>& known);

}  // namespace railpem::app
