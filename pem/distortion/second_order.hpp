#pragma once
// What squares and higher powers of a response hold, as sources of excitation.

#include <array>
#include <complex>
#include <functional>
#include <vector>

#include "pem/coupling/excitation.hpp"

namespace railpem::pem {

/// A response under the wheels per unit irregularity under each of the four, at 1, 2, … Hz; [wheel·4 + source].
using SquareTransfers = std::vector<std::array<std::complex<double>, 16>>;

inline constexpr double kSquareStep_hz = 1.0;  ///< of the lines of SquareTransfers
inline constexpr int kSquareRailEvery = 2;     ///< the rail is solved at every second of them

/// How squares under four wheels can differ: leading and trailing wheels, the two bogies, and both.
inline constexpr std::array<std::array<double, 4>, 3> kContrasts{
    {{1.0, -1.0, 1.0, -1.0}, {1.0, 1.0, -1.0, -1.0}, {1.0, -1.0, -1.0, 1.0}}};

inline constexpr std::size_t kPairs = 10;  ///< of wheels i ≤ j

/// Correlations of a response under every two wheels, as each meets the track: the delays between the wheels taken off.
/// In the response's unit squared, by lags of a grid.
struct PairCorrelations {
    std::size_t lines = 0;  ///< of the transfers
    std::array<std::vector<double>, kPairs> at;
    /// Of wheel i.
    double variance(std::size_t wheel) const {
        constexpr std::array<std::size_t, 4> kOwn{0, 4, 7, 9};
        return at[kOwn[wheel]].front();
    }
};

/// For powers up to `highest` of the correlations, whose spectra are as many times as broad.
PairCorrelations pair_correlations(const SquareTransfers& transfers, const std::vector<DelayedSpectrum>& broadband,
                                   const std::vector<double>& wheels_m, double speed_m_per_s, int highest);

/// One-sided spectra at 0, 1, … Hz of Σ_ij s_i s_j/16·(R_ij/scale)^power for each s of kContrasts: what z = ¼Σ
/// s_i·He_n(y_i) of Gaussian y with deviation 1 have, over n! (Mehler 1866). What is alike under all wheels cannot be
/// told from irregularity and is left out; the three contrasts are as good as independent by symmetry, each a source
/// with the shares s.
std::vector<std::vector<double>> contrasts_of_powers(const PairCorrelations& correlations, int power, double scale);

/// Of Gaussian y with the two-sided cross-spectra S_ij, the delays between the wheels taken off, the squares have the
/// cross-spectra 2·∫ S_ij(f − g)·S_ij(g) dg (Isserlis 1918). One-sided PSD of z = ¼Σ s_i·y_i², s of kContrasts, at 0,
/// 1, … Hz, in the response's unit to the fourth per Hz, of each. The second is what waves carry from one bogie to the
/// other on pads that hardly damp.
std::vector<std::vector<double>> contrasts_of_squares(const SquareTransfers& transfers,
                                                      const std::vector<DelayedSpectrum>& broadband,
                                                      const std::vector<double>& wheels_m, double speed_m_per_s);

/// The source of a contrast; `power` at 0, 1, … Hz in m²/Hz, straight between the lines and nothing beyond them.
DelayedSpectrum contrast_source(const char* name, std::size_t contrast, std::vector<double> power);

}  // namespace railpem::pem
