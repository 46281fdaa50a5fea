#pragma once

#include <string>

#include "diagnosis/findings/diagnosis.hpp"

namespace railpem::app {

/// report.html: a page that needs nothing beside it, light and dark, for a screen of any width and for paper. In this
/// order: the verdict; where it is; recorded against believed, retuned and diagnosed; what was left out; how much it
/// explains; what calibration would have hidden; rivals; what remains; inferred stiffnesses; the data; `command`, which
/// repeats it.
std::string diagnosis_report(const diagnosis::Diagnosis& diagnosis, const std::string& command);

}  // namespace railpem::app
