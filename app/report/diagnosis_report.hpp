#pragma once

#include <string>
#include <vector>

#include "app/provenance.hpp"
#include "diagnosis/findings/diagnosis.hpp"

namespace railpem::app {

/// What a report says beside the diagnosis.
struct ReportContext {
    std::string command;                     ///< which repeats it
    std::vector<std::string> doubts = {};    ///< what is hardly believed of the case
    const Provenance* provenance = nullptr;  ///< inputs with their hashes; nothing: not said
};

/// report.html: a page that needs nothing beside it, light and dark, for a screen of any width and for paper. In this
/// order: the verdict; where it is; recorded against believed, retuned and diagnosed; what was left out; how much it
/// explains; what calibration would have hidden; rivals; what remains; inferred stiffnesses; the data and the
/// context.
std::string diagnosis_report(const diagnosis::Diagnosis& diagnosis, const ReportContext& context);

}  // namespace railpem::app
