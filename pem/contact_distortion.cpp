#include "pem/contact_distortion.hpp"

#include <algorithm>
#include <cmath>

#include "pem/coupled_model.hpp"
#include "pem/solution.hpp"
#include "pem/wheel_transfers.hpp"
#include "pem/contact.hpp"

namespace railpem::pem {

namespace {

double shortest_wave(const spectra::IrregularityParameters& irregularity) {
    double shortest = 1e300;
    for (const spectra::IrregularityBand& band : irregularity.bands) shortest = std::min(shortest, band.shortest_wavelength_m);
    return shortest;
}

}  // namespace

DelayedSpectrum contact_distortion(const CaseParameters& parameters, double speed, const std::function<double(double)>& force_power_ratio) {
    const std::vector<double> wheels = vehicle::wheel_positions(parameters.vehicle);
    const CoupledModel model = coupled_model(parameters, speed);
    const Excitation excited = excitation(parameters, wheels, speed);
    const auto lines = static_cast<std::size_t>(speed / shortest_wave(parameters.irregularity) / kSquareStep_hz);
    std::vector<RailGroup> rails = rail_groups(model, kSquareStep_hz, kSquareStep_hz, lines, kSquareRailEvery, 1);
    const WheelTransfers force = wheel_transfers(model, kSquareStep_hz, kSquareStep_hz, lines, {response_index("contact_1"), response_index("contact_2")}, 1, &rails);
    BogieTransfers transfers(lines);
    for (std::size_t line = 0; line < lines; ++line) {
        const double amplitude = std::sqrt(std::max(0.0, force_power_ratio(static_cast<double>(line + 1) * kSquareStep_hz)));
        for (std::size_t i = 0; i < 8; ++i) transfers[line][i] = amplitude * force.at(line)[i];
    }
    std::vector<double> power = half_difference_of_squares(transfers, excited.broadband, wheels, speed);
    const double curvature_m_per_n2 = -2.0 / 9.0 * contact_constant(parameters.contact, parameters.vehicle.wheel_radius_m) * std::pow(wheel_load_n(parameters), -4.0 / 3.0);
    for (double& own : power) own *= 0.25 * curvature_m_per_n2 * curvature_m_per_n2;
    return difference_source("contact_distortion", std::move(power));
}

}  // namespace railpem::pem
