#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "recordings/inspection/inspection_report.hpp"

namespace railpem::recordings {

/// One screen of text: what is there, how good it is, what is wrong. At most 100 columns wide.
std::string to_text(const InspectionReport& report);

/// Everything in the report but the spectrograms. Not-a-number becomes null.
nlohmann::ordered_json to_json(const InspectionReport& report);

/// A page that needs nothing beside it: verdict, faults, channels, spectra, coherence and spectrogram with the named
/// lines.
std::string to_html(const InspectionReport& report);

}  // namespace railpem::recordings
