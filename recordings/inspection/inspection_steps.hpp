#pragma once
// The steps of an inspection that one record and the joined sections of a long one share.

#include <vector>

#include "recordings/checks/inspection_context.hpp"
#include "recordings/estimates/cross_spectra.hpp"
#include "recordings/inspection/inspection_report.hpp"

namespace railpem::recordings {

/// Fills everything that follows from the spectra: PSD, third-octaves, incoherent part, noise, coherence, averages.
void describe_spectra(const CrossSpectra& spectra, InspectionReport& report);

/// Fills what follows from lines and speed: the wheel's rotation, the names of the lines and the named frequencies.
void name_lines(const InspectionContext& context, InspectionReport& report);

/// Errors first, else in the order in which they were found.
void sort_faults(std::vector<Fault>& faults);

}  // namespace railpem::recordings
