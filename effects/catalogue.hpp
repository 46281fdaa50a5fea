#pragma once
// The effects that exist. Every file of effects/catalogue holds one, as a function of the file's name; the list of them
// is written by the build (scripts/effects.cmake).

#include <string>
#include <vector>

#include "effects/effect_description.hpp"

namespace railpem::effects {

/// All of them in the order of their rows, those that exist only in `simulate` included.
const std::vector<EffectDescription>& catalogue();

/// The effect of that identifier, or null.
const EffectDescription* find_description(const std::string& id);

/// Identifier of the effect that is a wrong number of the case.
const std::string& wrong_number_id();

/// What the files of effects/catalogue describe, in any order: written by the build.
std::vector<EffectDescription> described_effects();

}  // namespace railpem::effects
