#pragma once
// Diagnoses with something in every field, one for each verdict. The numbers are invented, of the size that real ones
// have.

#include <vector>

#include "diagnosis/findings/diagnosis.hpp"

namespace railpem::app::testing {

/// The pads stiffen with frequency, two recordings of nine channels. A name in it tries to break pages and tables.
diagnosis::Diagnosis explained();
diagnosis::Diagnosis ambiguous();
diagnosis::Diagnosis consistent();
diagnosis::Diagnosis unexplained();
diagnosis::Diagnosis recording_fault();

/// All of them.
std::vector<diagnosis::Diagnosis> every_verdict();

}  // namespace railpem::app::testing
