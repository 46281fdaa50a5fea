#pragma once

#include "recordings/checks/evidence.hpp"
#include "recordings/checks/level_mistake.hpp"

namespace railpem::recordings::checks {

/// Third-octave levels of a channel over what the case predicts for it, dB, from 2 Hz to 0.4 of the sampling rate.
/// Strong are the bands within 25 dB of the strongest predicted one: a wrong peak does not move their median, and bands
/// that hold nothing but the sensor's noise do not count. Empty without a prediction.
LevelDifferences against_prediction(const Evidence& evidence, std::size_t channel);

}  // namespace railpem::recordings::checks
