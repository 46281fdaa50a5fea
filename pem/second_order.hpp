#pragma once
// What the square of a response holds, as a source of excitation.

#include <array>
#include <complex>
#include <functional>
#include <vector>

#include "pem/excitation.hpp"

namespace railpem::pem {

/// A response under wheels 1 and 2 per unit irregularity under each of the four, at 1, 2, … Hz; [wheel·4 + source].
using BogieTransfers = std::vector<std::array<std::complex<double>, 8>>;

inline constexpr double kSquareStep_hz = 1.0;  ///< of the lines of BogieTransfers
inline constexpr int kSquareRailEvery = 2;       ///< the rail is solved at every second of them

/// Of Gaussian y with the two-sided cross-spectra S_ij, the delays between the wheels taken off, the squares have the cross-spectra 2·∫ S_ij(f − g)·S_ij(g) dg (Isserlis 1918). What is
/// alike under all wheels cannot be told from irregularity and is left out; what is not is the difference between leading and trailing wheel of a bogie, the same in both bogies: one source
/// with the shares (1, −1, 1, −1) and a quarter of the power of y_1² − y_2². One-sided PSD of that at 0, 1, … Hz, in the response's unit to the fourth per Hz.
std::vector<double> half_difference_of_squares(const BogieTransfers& transfers, const std::vector<DelayedSpectrum>& broadband, const std::vector<double>& wheels_m, double speed_m_per_s);

/// That source; `power` at 0, 1, … Hz in m²/Hz, straight between the lines and nothing beyond them.
DelayedSpectrum difference_source(const char* name, std::vector<double> power);

}  // namespace railpem::pem
