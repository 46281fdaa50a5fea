#pragma once

#include <string_view>

namespace railpem::recordings {

/// Files built into the program. The first three are what every page needs (page_text.hpp puts them together).
std::string_view chart_library();     ///< Chart.js, with its licence in the first lines
std::string_view charts_script();     ///< page/charts.js: draws charts from JSON in the colours of the page
std::string_view page_style();        ///< page/page.css
std::string_view inspection_style();  ///< page/inspection.css

}  // namespace railpem::recordings
