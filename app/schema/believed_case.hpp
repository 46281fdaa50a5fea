#pragma once
// A case file, turned into what the diagnosis works on.

#include "app/schema/case_file.hpp"
#include "diagnosis/observations/believed_case.hpp"

namespace railpem::app {

/// The believed case with what belongs to the baseline of a moving record: convected rail and sleeper passing computed
/// from the case; a contact constant that was left to the wheel radius is written out, so that it can be retuned.
diagnosis::BelievedCase believed_case(const CaseFile& file);

}  // namespace railpem::app
