#pragma once
// Power under a PSD that is known on an increasing grid and linear between its lines. All functions: at least one line,
// as many values as lines, frequencies strictly increasing.

#include <optional>
#include <span>

namespace railpem::spectra {

/// Mean square over the whole grid: ∫S df in the PSD's unit times Hz; 0 for a single line.
double mean_square(std::span<const double> frequency_hz, std::span<const double> psd);

/// Root mean square over the whole grid.
double root_mean_square(std::span<const double> frequency_hz, std::span<const double> psd);

/// Mean square between low_hz and high_hz ≥ low_hz, parts of grid intervals included. No value when the grid does not
/// cover [low_hz, high_hz].
std::optional<double> mean_square_between(std::span<const double> frequency_hz, std::span<const double> psd,
                                          double low_hz, double high_hz);

}  // namespace railpem::spectra
