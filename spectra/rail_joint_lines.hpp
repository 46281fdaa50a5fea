#pragma once

#include "spectra/irregularity_parameters.hpp"

namespace railpem::spectra {

/// Dips at a regular distance as a Fourier series: amplitude in m of the cosine of `order` (≥ 1) in
/// z(x) = a_0/2 + Σ a_m cos(2πmx/spacing), x = 0 in the middle of a dip. With h the depth, l the length, L the spacing
/// and r = m·l/L: a_m = −(h·l/L)·sin(πr)/(πr·(1 − r²)), −h·l/(2L) at r = 1 (Fourier integral of the raised cosine).
/// Real because the dip is symmetric, and signed. The line at the temporal frequency order·v/spacing has the power
/// a_m²/2, in m².
double joint_line_amplitude_m(const RailJoints& joints, int order);

}  // namespace railpem::spectra
