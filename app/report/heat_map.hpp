#pragma once

#include <string>

#include "diagnosis/findings/diagnosis.hpp"

namespace railpem::app::report {

/// Level difference recording over model, channel × third octave, of the believed, the retuned and the diagnosed case,
/// one of the three shown at a time. Bands that differ beyond chance after retuning are outlined; dashed where it is
/// the relation of two channels that differs. Empty without channels.
std::string heat_maps(const diagnosis::Diagnosis& diagnosis);

}  // namespace railpem::app::report
