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

/// Contact forces per unit irregularity at kSquareStep_hz, 2·kSquareStep_hz, … to the shortest wave.
SquareTransfers force_transfers(const CaseParameters& parameters, double speed) {
    const CoupledModel model = coupled_model(parameters, speed);
    const auto lines = static_cast<std::size_t>(speed / shortest_wave(parameters.irregularity) / kSquareStep_hz);
    std::vector<RailGroup> rails = rail_groups(model, kSquareStep_hz, kSquareStep_hz, lines, kSquareRailEvery, 1);
    std::vector<std::size_t> contacts;
    for (const char* wheel : {"contact_1", "contact_2", "contact_3", "contact_4"}) contacts.push_back(response_index(wheel));
    const WheelTransfers force = wheel_transfers(model, kSquareStep_hz, kSquareStep_hz, lines, contacts, 1, &rails);
    SquareTransfers transfers(lines);
    for (std::size_t line = 0; line < lines; ++line) std::copy_n(force.at(line), 16, transfers[line].begin());
    return transfers;
}

}  // namespace

double contact_force_variation(const CaseParameters& parameters, double speed) {
    const std::vector<double> wheels = vehicle::wheel_positions(parameters.vehicle);
    const SquareTransfers force = force_transfers(parameters, speed);
    std::array<double, 4> power{};
    for (const DelayedSpectrum& source : excitation(parameters, wheels, speed).broadband)
        for (std::size_t line = 0; line < force.size(); ++line) {
            const std::array<std::complex<double>, 4> e = met(source, wheels, speed, static_cast<double>(line + 1) * kSquareStep_hz);
            for (std::size_t wheel = 0; wheel < 4; ++wheel) {
                std::complex<double> own = 0.0;
                for (std::size_t j = 0; j < 4; ++j) own += force[line][wheel * 4 + j] * e[j];
                power[wheel] += std::norm(own) * kSquareStep_hz;
            }
        }
    return std::sqrt(*std::max_element(power.begin(), power.end())) / wheel_load_n(parameters);
}

std::vector<DelayedSpectrum> contact_distortion(const CaseParameters& parameters, double speed, const std::function<double(double)>& force_power_ratio) {
    const std::vector<double> wheels = vehicle::wheel_positions(parameters.vehicle);
    SquareTransfers transfers = force_transfers(parameters, speed);
    for (std::size_t line = 0; line < transfers.size(); ++line)
        for (std::complex<double>& own : transfers[line]) own *= std::sqrt(std::max(0.0, force_power_ratio(static_cast<double>(line + 1) * kSquareStep_hz)));
    const double curvature_m_per_n2 = -2.0 / 9.0 * contact_constant(parameters.contact, parameters.vehicle.wheel_radius_m) * std::pow(wheel_load_n(parameters), -4.0 / 3.0);
    std::vector<DelayedSpectrum> sources;
    for (std::vector<double>& power : contrasts_of_squares(transfers, excitation(parameters, wheels, speed).broadband, wheels, speed)) {
        for (double& own : power) own *= 0.25 * curvature_m_per_n2 * curvature_m_per_n2;
        sources.push_back(contrast_source("contact_distortion", sources.size(), std::move(power)));
    }
    return sources;
}

}  // namespace railpem::pem
