#pragma once
// A spectral line on a frequency grid. A fluctuating speed widens a line to a Gaussian; what a grid shows of it is the
// average over each line's bin, exact whatever the grid, so that power is neither lost nor gained.

#include <span>
#include <vector>

namespace railpem::spectra {

/// Power of a Gaussian line (mean `line_hz`, standard deviation `deviation_hz` ≥ 0, total `power`) between low_hz and
/// high_hz ≥ low_hz, in the unit of `power`. With deviation 0 all of it lies in the bin with low ≤ line < high.
/// Accurate relative to the result also far out in the tails.
double line_power_in_bin(double low_hz, double high_hz, double line_hz, double power, double deviation_hz);

/// The line as a one-sided PSD on increasing lines (at least two), in the unit of `power` per Hz: power in the bin of
/// each grid line divided by the bin's width. Bins end half way to the neighbours, the outermost are symmetric about
/// their line. Σ psd·width is the power that lies within the outermost bin edges; on a uniform grid the width is the
/// step.
std::vector<double> line_psd(std::span<const double> frequency_hz, double line_hz, double power, double deviation_hz);

}  // namespace railpem::spectra
