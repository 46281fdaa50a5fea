#pragma once

#include "simulate/effects/hidden_effects.hpp"

namespace railpem::simulate {

/// A numeric parameter with its range and standard value.
HiddenParameter number_parameter(std::string name, std::string unit, double low, double high, double standard,
                                 std::string says);

/// Pads, rail, support, irregularity and wheels' shape: appended to the list.
void add_track_effects(std::vector<HiddenEffect>& list);

/// The effects of the catalogue as changes of a case: keys and parameters only, the physics is marched by itself.
std::vector<HiddenEffect> catalogue_effects();

/// The effects that exist in this folder only.
std::vector<HiddenEffect> only_here_effects();

}  // namespace railpem::simulate
