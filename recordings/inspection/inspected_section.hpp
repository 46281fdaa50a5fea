#pragma once
// One section of a recording, or all of a short one.

#include <optional>

#include "recordings/checks/inspection_context.hpp"
#include "recordings/estimates/cross_spectra.hpp"
#include "recordings/inspection/inspection_report.hpp"
#include "recordings/recording.hpp"

namespace railpem::recordings {

/// What one section shows by itself, and the spectra (2 s windows) from which those of the whole are made; none when
/// it has no complete window.
struct InspectedSection {
    InspectionReport report;  ///< without what describe_spectra() and name_lines() fill
    std::optional<CrossSpectra> spectra;
};

InspectedSection inspect_section(const Recording& recording, const InspectionContext& context);

}  // namespace railpem::recordings
