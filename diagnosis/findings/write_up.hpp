#pragma once
// What a search has found, written up for whoever asked.

#include "diagnosis/findings/diagnosis.hpp"
#include "diagnosis/findings/findings.hpp"

namespace railpem::diagnosis {

/// Verdict, names, places, figures and statement, into `result`.
void write_up(const Findings& findings, Diagnosis& result);

}  // namespace railpem::diagnosis
