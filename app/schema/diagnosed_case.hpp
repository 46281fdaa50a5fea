#pragma once
// The case that a diagnosis ends with, as files that `railpem solve` runs.

#include <string>

#include "diagnosis/findings/diagnosis.hpp"

namespace railpem::app {

inline constexpr const char* kDiagnosedIrregularity = "diagnosed.irregularity.csv";

/// The fitted irregularity as a table: cycles_per_m, psd_m3, corrugation and joints left out.
std::string irregularity_text(const pem::CaseParameters& numbers);

/// The case in TOML: retuned numbers, the named effects, and the irregularity from kDiagnosedIrregularity beside it.
std::string diagnosed_case_text(const diagnosis::Diagnosis& diagnosis);

}  // namespace railpem::app
