#pragma once

#include <string>
#include <vector>

#include "app/schema/case_file.hpp"
#include "app/tables/response_tables.hpp"

namespace railpem::app {

/// The *.summary.json text: per speed and response the rms over the frequency lines, the peak of the spectrum and its
/// frequency; ride comfort in the body; what the solver warned of; and `doubts`, what is hardly believed of the case.
std::string summary_text(const CaseFile& file, const std::vector<std::string>& doubts,
                         const std::vector<ResponseSpectra>& speeds);

/// Responses that no vehicle has, as warnings.
std::vector<std::string> response_warnings(const CaseFile& file, const std::vector<ResponseSpectra>& speeds);

/// rms of wheels, bogies and body per speed, for the eye: a line each.
std::string levels_text(const std::vector<ResponseSpectra>& speeds);

}  // namespace railpem::app
