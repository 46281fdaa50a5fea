#pragma once

#include <vector>

#include "recordings/fault.hpp"

namespace railpem::recordings::checks {

/// Takes out what follows from another fault that was found: one cause is told once.
void drop_consequences(std::vector<Fault>& faults);

}  // namespace railpem::recordings::checks
