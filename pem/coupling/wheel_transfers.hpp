#pragma once
// What the diagnosis fits: the responses to a unit irregularity under one wheel at a time. They carry no wheel delays
// and are smooth in frequency, so a coarse grid holds them.

#include <complex>
#include <cstddef>
#include <vector>

#include "pem/coupling/coupled_model.hpp"

namespace railpem::pem {

/// Transfers on the uniform grid from_hz + i·step_hz.
struct WheelTransfers {
    double from_hz = 0.0;
    double step_hz = 1.0;
    std::size_t lines = 0;
    std::vector<std::size_t> responses;        ///< indices into response_names()
    std::vector<std::complex<double>> values;  ///< [line][response][wheel]: (m/s²)/m, N/m for forces

    const std::complex<double>* at(std::size_t line) const { return values.data() + line * responses.size() * 4; }
};

/// Solves the transfers of a prepared (and, if need be, linearised) model on a grid; lines in parallel.
/// `rails`: kept from an earlier call with the same track, speed and grid they are used again; empty ones are filled.
WheelTransfers wheel_transfers(const CoupledModel& model, double from_hz, double step_hz, std::size_t lines,
                               std::vector<std::size_t> responses, int threads = 0,
                               std::vector<RailGroup>* rails = nullptr);

/// The rail on that grid, for wheel_transfers(). Solved at every `every`-th line and interpolated between them
/// (six-point Lagrange, on the even side where the band ends): a rail on pads is smooth over several hertz, one with
/// dampers or bending sleepers is not.
std::vector<RailGroup> rail_groups(const CoupledModel& model, double from_hz, double step_hz, std::size_t lines,
                                   int every, int threads = 0);

/// The transfers between the grid's lines by cubic (four-point Lagrange) interpolation into `result`,
/// [response][wheel]; the nearest cubic beyond the ends. Error (step⁴·3/128)·|T''''|; a resonance of half-power width b
/// needs a step of at most b/2 for 1 %.
void interpolate(const WheelTransfers& transfers, double frequency_hz, std::complex<double>* result);

}  // namespace railpem::pem
