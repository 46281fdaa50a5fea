#pragma once

#include <string_view>

namespace railpem::app {

/// Files built into the program: for the report of a diagnosis, and the case that a proof believes.
std::string_view report_style();   ///< page/report.css
std::string_view report_script();  ///< page/report.js
std::string_view proved_case();    ///< cases/wei2016/case1.toml

}  // namespace railpem::app
