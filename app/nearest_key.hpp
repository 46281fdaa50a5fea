#pragma once

#include <string>
#include <vector>

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

}  // namespace railpem::app
