#pragma once

#include <string>
#include <vector>

#include "spectra/irregularity_parameters.hpp"

namespace railpem::spectra {

/// One sentence for every band that reaches beyond the wavelengths for which its family was measured, or beyond the
/// ends of its table. Such a band is allowed: gaps between the families are usually bridged so; but it is said.
std::vector<std::string> validity_warnings(const IrregularityParameters& irregularity);

}  // namespace railpem::spectra
