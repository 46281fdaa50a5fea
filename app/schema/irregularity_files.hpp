#pragma once

#include "app/schema/document.hpp"
#include "spectra/irregularity_parameters.hpp"

namespace railpem::app {

/// Reads the file of every [[irregularity.band]] that names one, relative to the folder of the document, and leaves a
/// band of the family `table` that no longer needs it: a measured spectrum as it stands, a profile as Welch's estimate
/// of its spectrum. So a case that is written again holds what was measured. Throws InputError with the line of the
/// file, or of the case where the file as a whole is wrong.
void read_irregularity_files(const Document& document, spectra::IrregularityParameters& irregularity);

}  // namespace railpem::app
