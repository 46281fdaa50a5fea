#pragma once
// Spectra and frequency responses in universal files.

#include <string>

#include "recordings/files/data_table.hpp"
#include "recordings/recording.hpp"

namespace railpem::recordings {

bool is_universal_file(const std::string& file);

/// Power spectral densities (function type 9, or an auto-spectrum whose unit is per Hz), one record per channel, each
/// in the unit that description and record 9 say. Fills Recording::spectra without standard errors. Throws ReadError or
/// parameters::ParameterError.
void load_uff_densities(Recording& recording, const ReadLimits& limits);

/// A frequency response (function type 4) to a force, as receptance. Which: the record that the first channel's column
/// names, else the first. Receptance, mobility or accelerance by the data
/// type of its ordinate, or by its unit. Throws ReadError.
void load_uff_receptance(Recording& recording, const ReadLimits& limits);

}  // namespace railpem::recordings
