#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "recordings/inspection/inspection_report.hpp"

namespace railpem::recordings {

/// Data of the page's charts, as page/charts.js takes them: {named: [{f, name}], charts: [{id, x, y, yType, sets,
/// marks}]}.
nlohmann::json chart_data(const InspectionReport& report);

/// One spectrogram as a picture with axes and the named lines, as SVG with an embedded PNG.
std::string spectrogram_svg(const Spectrogram& spectrogram, const InspectionReport& report);

}  // namespace railpem::recordings
