#pragma once
// The receptances of wheels that roll over equal seats, over a whole band.

#include <array>
#include <complex>
#include <vector>

#include "pem/coupling/coupled_model.hpp"
#include "track/rail/rolling_receptance.hpp"

namespace railpem::pem {

/// track::rolling_receptance() at 0, step, 2·step, … with two orders on either side, three where the rail shears.
struct RollingTable {
    double step_hz = 4.0;
    std::vector<track::RollingReceptance> at;  ///< empty: nothing rolls
};

/// Up to `to_hz`. The step is 4 Hz, and as much finer as the pads' loss tangent is below 0.4: the rail on its pads
/// resonates as narrowly. Nothing where `model` is at rest. `near`: of a case that differs by little, of which a
/// derivative is taken: from the fifteenth line on every second tells how, and the difference is interpolated between
/// them. Where the difference is smooth it is right to 2e-3 (RollingTable.ChangeIsToldByEverySecondLine); a correction
/// that bends at a node is told less well.
RollingTable rolling_table(const CoupledModel& model, double speed_m_per_s, double to_hz,
                           const RollingTable* near = nullptr);

/// R_m at a frequency of either sign, [felt at·4 + force at], m/N; six-point Lagrange. Zero beyond the orders of the
/// table.
std::array<std::complex<double>, 16> rolling_at(const RollingTable& table, int order, double frequency_hz);

/// The rail on the grid from_hz + i·step_hz, as rail_groups() has it, of a `model` in motion. What seats add that are
/// not equal is solved at `every` few lines and interpolated, as by rail_groups().
std::vector<RailGroup> rolling_rails(const RollingTable& table, const CoupledModel& model, double from_hz,
                                     double step_hz, std::size_t lines, int every = 1, int threads = 1);

}  // namespace railpem::pem
