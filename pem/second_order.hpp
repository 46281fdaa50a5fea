#pragma once
// What the square of a response holds, as a source of excitation.

#include <array>
#include <complex>
#include <functional>
#include <vector>

#include "pem/excitation.hpp"

namespace railpem::pem {

/// A response under the wheels per unit irregularity under each of the four, at 1, 2, … Hz; [wheel·4 + source].
using SquareTransfers = std::vector<std::array<std::complex<double>, 16>>;

inline constexpr double kSquareStep_hz = 1.0;  ///< of the lines of SquareTransfers
inline constexpr int kSquareRailEvery = 2;       ///< the rail is solved at every second of them

/// How squares under four wheels can differ: leading and trailing wheels, the two bogies, and both.
inline constexpr std::array<std::array<double, 4>, 3> kContrasts{{{1.0, -1.0, 1.0, -1.0}, {1.0, 1.0, -1.0, -1.0}, {1.0, -1.0, -1.0, 1.0}}};

/// Of Gaussian y with the two-sided cross-spectra S_ij, the delays between the wheels taken off, the squares have the cross-spectra 2·∫ S_ij(f − g)·S_ij(g) dg (Isserlis 1918). What is
/// alike under all wheels cannot be told from irregularity and is left out; the rest are three contrasts z = ¼Σ s_i·y_i², s of kContrasts, as good as independent by symmetry, each a source with the shares s.
/// One-sided PSD of z at 0, 1, … Hz, in the response's unit to the fourth per Hz, of each. The second is what waves carry from one bogie to the other on pads that hardly damp.
std::vector<std::vector<double>> contrasts_of_squares(const SquareTransfers& transfers, const std::vector<DelayedSpectrum>& broadband, const std::vector<double>& wheels_m,
                                                      double speed_m_per_s);

/// The source of a contrast; `power` at 0, 1, … Hz in m²/Hz, straight between the lines and nothing beyond them.
DelayedSpectrum contrast_source(const char* name, std::size_t contrast, std::vector<double> power);

}  // namespace railpem::pem
