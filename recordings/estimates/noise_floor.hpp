#pragma once

#include <vector>

#include "recordings/estimates/cross_spectra.hpp"

namespace railpem::recordings {

/// What of a channel's PSD the other channels do not explain linearly: 1/(S⁻¹)_ii, corrected for the averages spent on
/// the others by K/(K − p + 1). An upper bound of the sensor's noise, per bin, unit²/Hz. NaN where the averages do not
/// suffice (K < 2p) or a channel has no power.
std::vector<double> incoherent_part(const CrossSpectra& spectra, std::size_t channel);

}  // namespace railpem::recordings
