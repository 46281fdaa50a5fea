#pragma once

#include <string>
#include <vector>

#include "app/tables/response_tables.hpp"
#include "pem/case_parameters.hpp"

namespace railpem::app {

/// The *.summary.json text: per speed and response the rms over the frequency lines, the peak of the spectrum and its
/// frequency; ride comfort in the body; and what the solver warned of.
std::string summary_text(const std::string& case_name, const pem::CaseParameters& parameters,
                         const std::vector<ResponseSpectra>& speeds);

}  // namespace railpem::app
