#pragma once
// Forces under wheels that roll over supports, which answer to an irregularity at one frequency at many.

#include <array>
#include <complex>
#include <vector>

#include "pem/distortion/passing_modulation.hpp"

namespace railpem::pem {

/// For an irregularity at f' = kStep_hz, 2·kStep_hz, … (of ModulationTransfers): what is felt under the wheels at f' +
/// shift beside it, per unit under each of the four wheels at f'; [wheel·4 + source], smooth, straight between the
/// lines.
struct FeltOrder {
    double shift_hz = 0.0;
    std::vector<std::array<std::complex<double>, 16>> at;
};

/// All orders of whole bays at once: the forces P_m at f' + m·v/spacing, obey
///   P_m = H_m·(r·δ_m0 − Σ_n R_{m−n}(f' + n·v/spacing)·P_n),  n ≠ m,
/// H the contact forces per irregularity; as many orders as `orders` has, three at most. The first order alone (P_0
/// without what comes back) leaves −42 dB of the record where pads hardly damp (Modulation.*). Differing seats follow
/// to first order, from P_0. The first element has shift 0: what comes back; then all of `orders`.
std::vector<FeltOrder> felt_orders(const std::vector<Modulation>& orders, const ModulationTransfers& transfers);

/// At a frequency > 0 of the irregularity.
std::array<std::complex<double>, 16> at_frequency(const FeltOrder& order, double from_hz);

/// The lines of a wheel out of round with what comes back of them, and beside each one at f + shift for every order: 40
/// dB below a line that may itself stand 30 dB above all else. A frequency below zero is its conjugate above.
LineSet felt_lines(const std::vector<FeltOrder>& orders, const LineSet& lines);

/// The pseudo-irregularity at a frequency that the order `which` makes of a broadband source, m/√Hz; the first beside
/// the source itself.
std::array<std::complex<double>, 4> felt_irregularity(const std::vector<FeltOrder>& orders, std::size_t which,
                                                      const DelayedSpectrum& source,
                                                      const std::vector<double>& wheels_m, double speed_m_per_s,
                                                      double frequency_hz);

}  // namespace railpem::pem
