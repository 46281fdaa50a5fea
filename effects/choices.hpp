#pragma once
// Choices that several effects have.

#include "effects/effect_description.hpp"

namespace railpem::effects {

/// low, low + 1, … high as texts.
std::vector<std::string> whole_numbers(int low, int high);

/// The channel of a sensor effect: those that a recording of the train may have.
EffectChoice channel_choice();

}  // namespace railpem::effects
