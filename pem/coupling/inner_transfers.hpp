#pragma once
// Responses to forces that arise inside the suspension: what a nonlinear element adds to its linearised law.

#include <complex>
#include <cstddef>
#include <vector>

#include "pem/coupling/coupled_model.hpp"

namespace railpem::pem {

/// Transfers on the uniform grid from_hz + i·step_hz.
struct InnerTransfers {
    double from_hz = 0.0;
    double step_hz = 1.0;
    std::size_t lines = 0, responses = 0, elements = 0;
    std::vector<std::complex<double>> values;  ///< [line][response][element]: (m/s²)/N, N/N for forces

    const std::complex<double>* at(std::size_t line) const { return values.data() + line * responses * elements; }
};

/// Responses to a unit force that elongates each element of a stage (`law`: primary, four elements; secondary, two).
/// With q the force, u = V_eq·q what it moves the free wheels by: P = −(1/K_h + V + R)⁻¹·u, the wheels being pressed on
/// the rail by what they move. `rails`: of the same grid, as rail_groups() makes them. `responses`: indices into
/// response_names().
InnerTransfers inner_transfers(const CoupledModel& model, vehicle::Law law, double from_hz, double step_hz,
                               std::size_t lines, const std::vector<std::size_t>& responses,
                               const std::vector<RailGroup>& rails);

/// How the elements of a stage move, on the uniform grid from_hz + i·step_hz.
struct ElementTransfers {
    double from_hz = 0.0;
    double step_hz = 1.0;
    std::size_t lines = 0, elements = 0;
    /// [line][moved][forced]: velocity across an element by a unit force that elongates one, (m/s)/N
    std::vector<std::complex<double>> mobility;
    /// [line][element][wheel]: velocity by a unit irregularity under a wheel, 1/s
    std::vector<std::complex<double>> by_wheel;
};

/// Of a stage of a prepared and linearised model, arguments as above.
ElementTransfers element_transfers(const CoupledModel& model, vehicle::Law law, double from_hz, double step_hz,
                                   std::size_t lines, const std::vector<RailGroup>& rails);

}  // namespace railpem::pem
