#pragma once
// Looks at a recording, or at a file of any length.

#include <filesystem>

#include "recordings/checks/inspection_context.hpp"
#include "recordings/inspection/inspection_report.hpp"
#include "recordings/recording.hpp"

namespace railpem::recordings {

/// Looks at a recording with everything that is believed about it. Changes nothing.
InspectionReport inspect(const Recording& recording, const InspectionContext& context = {});

/// The same for a file of any length: a CSV time series of more than `samples` per channel is inspected section by
/// section in bounded memory, and the reports are joined (faults with their times, spectra averaged, the first
/// section's figures shown).
InspectionReport inspect_file(const RecordingDescription& description, const std::filesystem::path& base,
                              const InspectionContext& context = {}, std::size_t samples = 600000);

}  // namespace railpem::recordings
