#pragma once

#include <string_view>

namespace railpem::recordings {

/// Files built into the program.
std::string_view chart_script();  ///< Chart.js, with its licence in the first lines
std::string_view page_script();   ///< page/inspection.js
std::string_view page_style();    ///< page/inspection.css

}  // namespace railpem::recordings
