#pragma once

#include <string>
#include <vector>

#include "diagnosis/findings/diagnosis.hpp"

namespace railpem::app {

/// diagnosis.json: verdict, statement, omitted, posterior, rivals, places, mismatch, fit and hidden_by_retuning, and
/// after them what else the diagnosis knows. Numbers are read back bit by bit; one that does not exist is null.
/// `omitted` has an entry per instance of an effect and is empty when the verdict is `consistent` or `ambiguous`.
/// `doubts`: what is hardly believed of the case.
std::string diagnosis_json(const diagnosis::Diagnosis& diagnosis, const std::vector<std::string>& doubts = {});

}  // namespace railpem::app
