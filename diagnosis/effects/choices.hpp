#pragma once
// Choices that several effects have.

#include <string>
#include <vector>

namespace railpem::diagnosis {

/// low, low + 1, … high as texts.
std::vector<std::string> whole_numbers(int low, int high);

/// The channels that a recording of the train may have.
const std::vector<std::string>& channel_names();

}  // namespace railpem::diagnosis
