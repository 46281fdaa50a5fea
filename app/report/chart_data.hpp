#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>

#include "diagnosis/findings/diagnosis.hpp"

namespace railpem::app::report {

/// The comparison that shows best what is wrong: the channel of the most certain mismatch, or else the one with the
/// largest level differences. Index into diagnosis.channels, which must not be empty.
std::size_t worst_channel(const diagnosis::Diagnosis& diagnosis);

/// Root mean square over the third octaves that say something; NaN when none does.
double rms_level_db(const std::vector<double>& levels_db);

/// What page/report.js draws: {charts: the worst channel and the inferred curves, as recordings/page/charts.js takes
/// them; channels: [{name, f, sets, bands}], for the selector; worst: index}.
nlohmann::json chart_data(const diagnosis::Diagnosis& diagnosis);

}  // namespace railpem::app::report
