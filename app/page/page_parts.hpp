#pragma once

#include <string_view>

namespace railpem::app {

/// Files built into the program, for the report of a diagnosis.
std::string_view report_style();   ///< page/report.css
std::string_view report_script();  ///< page/report.js

}  // namespace railpem::app
