#pragma once

#include <vector>

#include "diagnosis/findings/diagnosis.hpp"
#include "diagnosis/judge/spoiled_values.hpp"

namespace railpem::diagnosis {

/// Turns what was found with the slips undone into what is to be said of the recordings as they were handed in: a
/// `recording-fault` that says every slip with its factor, then what they say once it is undone.
void say_spoiled(const std::vector<SpoiledChannel>& spoiled, Diagnosis& result);

}  // namespace railpem::diagnosis
