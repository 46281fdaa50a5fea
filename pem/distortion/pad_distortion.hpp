#pragma once
// What pads that stiffen under load add to the linear response: their stiffness follows the load of every moment.

#include <array>
#include <complex>
#include <vector>

#include "pem/coupling/coupled_model.hpp"
#include "pem/coupling/excitation.hpp"
#include "pem/distortion/second_order.hpp"

namespace railpem::pem {

/// What of the distortion does not depend on the excitation, at 1, 2, … Hz.
struct PadTransfers {
    SquareTransfers rail;           ///< displacement of the rail
    std::vector<double> response2;  ///< |½(κ/C³)·R·g|², as below
    double force_per_m2 = 0.0;      ///< ½κ/C³
    std::vector<RailGroup> rails;
};

/// Of a prepared model at its speed. Empty where load does not stiffen the pads. `same_track`: of a case with the same
/// track, speed and static wheel load.
PadTransfers pad_transfers(const CaseParameters& parameters, const CoupledModel& model,
                           const PadTransfers* same_track = nullptr);

/// Second-order distortion. Under a load P0 + F(t) the rail sinks by w(P0) + C·F + ½κF² (track::loaded_deflection());
/// seen as a law of the pads under the wheel, their force lacks q = −½(κ/C³)·g∗y², y the rail's displacement there, g
/// the shape of the pads in frequency, and the rail moves by R·q, which acts like an irregularity d_i under wheel i:
/// sources as second_order.hpp has them, the squares of y times |½(κ/C³)·R·g|². Tens of dB below the linear response,
/// it decides what their coherence says (NullRecord.PadsThatStiffenUnderLoadDistort: whitened trace 1.47 without it). R
/// is that of the wheel's own point, κ and C are those at rest frequency over a pad; third order is left out. Empty for
/// empty transfers.
std::vector<DelayedSpectrum> pad_distortion(const PadTransfers& transfers,
                                            const std::vector<DelayedSpectrum>& broadband,
                                            const std::vector<double>& wheels_m, double speed_m_per_s);

}  // namespace railpem::pem
