#pragma once
// What `diagnose` reads, turned into what the diagnosis works on.

#include <string>
#include <vector>

#include "app/schema/case_schema.hpp"
#include "app/schema/recording_schema.hpp"
#include "diagnosis/observations/believed_case.hpp"
#include "recordings/recording.hpp"

namespace railpem::app {

/// The believed case with what belongs to the baseline of a moving record: convected rail and sleeper passing computed
/// from the case; a contact constant that was left to the wheel radius is written out, so that it can be retuned.
diagnosis::BelievedCase believed_case(const CaseFile& file);

/// The data of a recording. Throws InputError.
recordings::Recording load_recording(const RecordingFile& file);

}  // namespace railpem::app
