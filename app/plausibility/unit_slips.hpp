#pragma once
// Which other unit would make a value right.

#include <string>

namespace railpem::app {

/// "GPa?" for 210 where 1.5e11 to 2.5e11 Pa are believed: the unit that the value would be believed in, of those that
/// the field uses for quantities in `unit`. Empty when none does. Of several the one that brings it nearest to the
/// middle of the range (geometric).
std::string likely_unit(double value, const std::string& unit, double low, double high);

}  // namespace railpem::app
