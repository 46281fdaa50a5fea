#pragma once

#include "simulate/hidden_effects.hpp"

namespace railpem::simulate {

/// The effects of the catalogue as changes of a case: keys and parameters only, the physics is marched by itself.
std::vector<HiddenEffect> catalogue_effects();

/// The effects that exist in this folder only.
std::vector<HiddenEffect> only_here_effects();

}  // namespace railpem::simulate
