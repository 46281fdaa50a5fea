#pragma once

#include "app/schema/case_file.hpp"
#include "app/schema/recording_schema.hpp"
#include "recordings/checks/inspection_context.hpp"

namespace railpem::app {

/// What a case says that helps to judge a recording: where the wheels stand, the wheel radius, the sleeper spacing, and
/// the spectrum that it predicts for every channel at the recording's speed and payload (the case's own where the
/// recording does not state them). A place on the body between and beyond the pivots moves as a rigid body; where the
/// case has the body bend, only its centre and the pivots are predicted. Throws InputError.
recordings::InspectionContext inspection_beliefs(const CaseFile& believed, const RecordingFile& recording);

}  // namespace railpem::app
